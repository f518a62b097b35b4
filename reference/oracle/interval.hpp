#pragma once
// Numbers of which only bounds are known: what the pipeline's float may be.
//
// Colours are the one thing that the documents do not fix to the last bit: they say which sum or
// product is meant, not in which order it is rounded. So the oracle computes bounds. Each operation
// works on the bounds in double and then moves them apart by kRounding of their size, twice what one
// float operation can err; a float computation of the same formula therefore ends between them.

#include <algorithm>
#include <cmath>
#include <limits>

namespace tuberia::oracle {

inline constexpr double kRounding = 0x1p-23;   // one float operation errs by at most 2^-24 of its result
inline constexpr double kSmallest = 0x1p-148;  // and by 2^-150 among the denormals

struct Interval {
  double low = 0, high = 0;
  constexpr Interval() = default;
  constexpr Interval(double exact) : low(exact), high(exact) {}
  constexpr Interval(double least, double most) : low(least), high(most) {}
  bool operator==(const Interval&) const = default;
  bool is_exact() const { return low == high; }
  bool is_known() const { return std::isfinite(low) && std::isfinite(high); }
};

/// Any number at all, and not-a-number, too.
inline Interval unknown() { return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}; }

/// A float as it is, if it is a number.
inline Interval one_float(float x) { return std::isfinite(x) ? Interval(static_cast<double>(x)) : unknown(); }

/// Both bounds moved apart by a share of their size.
inline Interval widened(Interval a, double share = kRounding) {
  if (!a.is_known()) return unknown();
  const double margin = std::max(std::abs(a.low), std::abs(a.high)) * share + kSmallest;
  // What overflows a float is no number we can follow.
  if (std::max(std::abs(a.low), std::abs(a.high)) > 3e38) return unknown();
  return {a.low - margin, a.high + margin};
}

inline Interval hull(Interval a, Interval b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

// Sums with 0 and products with 0 and 1 are exact in any arithmetic.
inline Interval operator+(Interval a, Interval b) {
  if (a == Interval(0.0)) return b;
  if (b == Interval(0.0)) return a;
  return widened({a.low + b.low, a.high + b.high});
}
inline Interval operator-(Interval a) { return {-a.high, -a.low}; }
inline Interval operator-(Interval a, Interval b) {
  if (a.is_exact() && a == b && a.is_known()) return 0.0;
  return a + (-b);
}
inline Interval operator*(Interval a, Interval b) {
  if (!a.is_known() || !b.is_known()) return unknown();
  if (a == Interval(0.0) || b == Interval(0.0)) return 0.0;
  if (a == Interval(1.0)) return b;
  if (b == Interval(1.0)) return a;
  const double products[4] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  const auto [least, most] = std::minmax_element(products, products + 4);
  return widened({*least, *most});
}
inline Interval operator/(Interval a, Interval b) {
  if (!a.is_known() || !b.is_known() || (b.low <= 0 && b.high >= 0)) return unknown();
  if (a == Interval(0.0)) return 0.0;
  if (b == Interval(1.0)) return a;
  const double quotients[4] = {a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high};
  const auto [least, most] = std::minmax_element(quotients, quotients + 4);
  return widened({*least, *most});
}

inline Interval clamped(Interval a, double least, double most) {
  return {std::clamp(a.low, least, most), std::clamp(a.high, least, most)};
}
inline Interval smaller(Interval a, Interval b) { return {std::min(a.low, b.low), std::min(a.high, b.high)}; }
inline Interval larger(Interval a, Interval b) { return {std::max(a.low, b.low), std::max(a.high, b.high)}; }
inline Interval absolute(Interval a) {
  if (a.low >= 0) return a;
  if (a.high <= 0) return -a;
  return {0, std::max(-a.low, a.high)};
}

/// The answer to a question about numbers of which only bounds are known.
enum class Outcome { no, maybe, yes };
inline Outcome both(Outcome a, Outcome b) { return std::min(a, b); }

}  // namespace tuberia::oracle
