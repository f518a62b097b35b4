#pragma once
// Whole numbers without bounds, quotients of them, and the two roundings that the machine knows: to the
// nearest whole number and to the nearest float, ties to even in both.

#include <gmpxx.h>

#include <cstdint>

namespace tuberia::rational {

using Integer = mpz_class;

/// numerator / denominator * 2^exponent; denominator > 0.
struct Quotient {
  Integer numerator, denominator{1};
  std::int64_t exponent = 0;
};

/// A finite number as mantissa * 2^exponent, with an odd mantissa or (0, 0).
struct Dyadic {
  std::int64_t mantissa = 0;
  int exponent = 0;
};
Dyadic dyadic(double finite) noexcept;

/// mantissa * 2^(exponent - unit): the number in units of 2^unit, which must divide it.
Integer in_units(const Dyadic&, int unit);

/// The nearest whole number; the even one of two that are equally near. Clamped to +-limit.
std::int64_t nearest_whole(const Quotient&, std::int64_t limit);

/// The nearest float, denormals included; of two equally near ones the one with the even last bit.
/// Infinite from half a step beyond the largest float on; 0 where it underflows.
float nearest_float(const Quotient&);

/// For reports only.
double approximately(const Quotient&);

}  // namespace tuberia::rational
