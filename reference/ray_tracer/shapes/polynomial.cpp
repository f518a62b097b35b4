#include "reference/ray_tracer/shapes/polynomial.hpp"

#include <cmath>

namespace tuberia::tracer {
namespace {

struct Value {
  double value = 0, slope = 0;
};

Value evaluate(std::span<const double> coefficients, double x) noexcept {
  Value at;
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    at.slope = at.slope * x + at.value;
    at.value = at.value * x + coefficients[i];
  }
  return at;
}

/// Newton's steps while they stay between the limits and get shorter fast enough, else halves.
double root_between(std::span<const double> coefficients, double low, double high) noexcept {
  const bool rises = evaluate(coefficients, low).value < 0;
  double x = 0.5 * (low + high), last_step = high - low;
  for (int i = 0; i < 200; ++i) {
    const Value at = evaluate(coefficients, x);
    if (at.value == 0) return x;
    ((at.value < 0) == rises ? low : high) = x;
    const double newton = x - at.value / at.slope;
    const bool is_useful = newton > low && newton < high && std::abs(newton - x) < 0.5 * last_step;
    const double next = is_useful ? newton : 0.5 * (low + high);
    last_step = std::abs(next - x);
    if (next == x || next == low || next == high) return next;
    x = next;
  }
  return x;
}

}  // namespace

PolynomialRoots sign_changes(std::span<const double> coefficients, double low, double high) noexcept {
  PolynomialRoots roots;
  if (coefficients.size() < 2) return roots;
  std::array<double, kMostRoots> derivative{};
  for (std::size_t i = 1; i < coefficients.size(); ++i) derivative[i - 1] = static_cast<double>(i) * coefficients[i];
  const PolynomialRoots turns = sign_changes({derivative.data(), coefficients.size() - 1}, low, high);

  double from = low;
  bool was_negative = evaluate(coefficients, low).value < 0;
  for (std::size_t i = 0; i <= turns.count; ++i) {
    const double to = i < turns.count ? turns.values[i] : high;
    const bool is_negative = evaluate(coefficients, to).value < 0;
    if (is_negative != was_negative && roots.count < kMostRoots) roots.values[roots.count++] = root_between(coefficients, from, to);
    from = to;
    was_negative = is_negative;
  }
  return roots;
}

}  // namespace tuberia::tracer
