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

Interval dot(const Triple& a, const Triple& b) { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; }

Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Interval root_of(Interval x) {
  if (!x.is_known()) return unknown();
  return widened({std::sqrt(std::max(x.low, 0.0)), std::sqrt(std::max(x.high, 0.0))});
}

/// The squared longer half axis over the product of both, held within 1 and the most; without any change 1.
Interval taps_of(Interval longest, Interval area, double most) {
  if (longest.high <= 0) return 1.0;
  const auto bounded = [&](double ratio) { return std::clamp(ratio, 1.0, most); };
  const double least = area.high > 0 ? longest.low / area.high : most;
  const double largest = area.low > 0 ? longest.high / area.low : most;
  const Interval ratio = widened({std::min(least, 1e30), std::min(largest, 1e30)});
  return {bounded(ratio.low), bounded(ratio.high)};
}

/// One coordinate of (x, y) to unit length; anywhere if the length may be 0.
Interval unit_share(Interval x, Interval y) {
  const Interval length = root_of(absolute(x) * absolute(x) + absolute(y) * absolute(y));
  const Interval share = x / length;
  return share.is_known() ? clamped(widened(share, 0x1p-20), -1.001, 1.001) : Interval{-1.001, 1.001};
}

/// The larger eigenvalue of ((a, b), (b, c)).
Interval squared_longer_axis(Interval a, Interval b, Interval c) {
  const Interval half = (a - c) * Interval(0.5);
  return (a + c) * Interval(0.5) + root_of(absolute(half) * absolute(half) + absolute(b) * absolute(b));
}

}  // namespace

Footprint stepped_footprint(const Steps& texels, float max_anisotropy) {
  const Interval a = squared_length(texels.x), c = squared_length(texels.y);
  if (!a.is_known() || !c.is_known()) return {unknown(), unknown(), unknown(), unknown()};
  const Interval longest = larger(a, c);
  Footprint footprint;
  // The ratio of the lengths is that of the longer one's square to their product.
  footprint.taps = taps_of(longest, root_of(a) * root_of(c), static_cast<double>(max_anisotropy));
  footprint.level_of_detail = log2_of(longest) * Interval(0.5) - log2_of(footprint.taps);
  const bool x_longer = a.low >= c.high, y_longer = c.low > a.high;
  footprint.along_x = x_longer ? Interval(1.0) : y_longer ? Interval(0.0) : Interval{0, 1};
  footprint.along_y = x_longer ? Interval(0.0) : y_longer ? Interval(1.0) : Interval{0, 1};
  return footprint;
}

Footprint round_footprint(const Steps& texels, FootprintForm form) {
  const Interval x = squared_length(texels.x), y = squared_length(texels.y);
  if (!x.is_known() || !y.is_known()) return {unknown()};
  if (form == FootprintForm::ellipse) {
    const Interval longest = squared_longer_axis(x, dot(texels.x, texels.y), y);
    return {longest.is_known() ? log2_of(larger(longest, 0.0)) * Interval(0.5) : unknown()};
  }
  return {log2_of(larger(x, y)) * Interval(0.5)};
}

Footprint elliptic_footprint(const Steps& texels, float max_anisotropy) {
  const Interval a = squared_length(texels.x), b = dot(texels.x, texels.y), c = squared_length(texels.y);
  const Interval half = (a - c) * Interval(0.5), root = root_of(absolute(half) * absolute(half) + absolute(b) * absolute(b));
  const Interval longest = (a + c) * Interval(0.5) + root, area = root_of(squared_length(cross(texels.x, texels.y)));
  if (!longest.is_known() || !area.is_known()) return {unknown(), unknown(), unknown(), unknown()};
  Footprint footprint;
  footprint.taps = taps_of(larger(longest, 0.0), area, static_cast<double>(max_anisotropy));
  footprint.level_of_detail = log2_of(larger(longest, 0.0)) * Interval(0.5) - log2_of(footprint.taps);
  // Where h may have either sign both forms name the same axis, maybe the other way round, which only
  // changes the order of the samples.
  const bool x_longer = half.low + half.high >= 0;
  const Interval along_x = x_longer ? half + root : b, along_y = x_longer ? b : root - half;
  footprint.along_x = unit_share(along_x, along_y);
  footprint.along_y = unit_share(along_y, along_x);
  return footprint;
}

}  // namespace tuberia::oracle
