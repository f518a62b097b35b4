#include "reference/oracle/footprint.hpp"

#include <cmath>

namespace tuberia::oracle {
namespace {

Interval squared_length(const Triple& a) {
  const auto square = [](Interval x) { return absolute(x) * absolute(x); };
  return (square(a[0]) + square(a[1])) + square(a[2]);
}

/// The machine's own logarithm, 3e-7 relative and rounded; below the normal floats it is -126.
Interval log2_of(Interval x) {
  if (!x.is_known()) return unknown();
  const auto log = [](double a) { return std::log2(std::max(a, 0x1p-126)); };
  const Interval exact{log(x.low), log(x.high)};
  return {exact.low - 5e-7 * std::abs(exact.low), exact.high + 5e-7 * std::abs(exact.high)};
}

}  // namespace

Interval level_of_detail(const Steps& texels) {
  const Interval x = squared_length(texels.x), y = squared_length(texels.y);
  if (!x.is_known() || !y.is_known()) return unknown();
  return log2_of(larger(x, y)) * Interval(0.5);
}

}  // namespace tuberia::oracle
