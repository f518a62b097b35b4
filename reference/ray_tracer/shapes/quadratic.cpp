#include "reference/ray_tracer/shapes/quadratic.hpp"

#include <algorithm>
#include <cmath>

namespace tuberia::tracer {
namespace {

/// b b - 4 a c, to 2^-52 of itself even where nearly nothing is left of it: the roundings of both products are added again.
double discriminant(double a, double b, double c) noexcept {
  const double square = b * b, product = 4 * a * c, difference = square - product;
  if (3 * std::abs(difference) >= square + product) return difference;
  return difference + (std::fma(b, b, -square) - std::fma(4 * a, c, -product));
}

}  // namespace

QuadraticRoots solve_quadratic(double a, double b, double c) noexcept {
  const double largest = std::max({std::abs(a), std::abs(b), std::abs(c)});
  if (!(largest > 0) || !std::isfinite(largest)) return {};
  // So that squares stay in the range of numbers; powers of two round nothing.
  const int exponent = -std::ilogb(largest);
  a = std::scalbn(a, exponent);
  b = std::scalbn(b, exponent);
  c = std::scalbn(c, exponent);

  if (a == 0 && b == 0) return {};
  if (a == 0) return {.count = 1, .first = -c / b, .second = -c / b};
  const double d = discriminant(a, b, c);
  if (!(d >= 0)) return {};
  // Of equal signs, so that nothing cancels; the other root follows from the product of both, c / a.
  const double sum = -0.5 * (b + std::copysign(std::sqrt(d), b));
  const double one = sum / a, other = sum == 0 ? 0 : c / sum;
  return {.count = 2, .first = std::min(one, other), .second = std::max(one, other)};
}

}  // namespace tuberia::tracer
