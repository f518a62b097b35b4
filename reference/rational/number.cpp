#include "reference/rational/number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tuberia::rational {
namespace {

Integer shifted_left(Integer value, std::int64_t bits) {
  mpz_mul_2exp(value.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(bits));
  return value;
}

/// The quotient as a fraction of whole numbers.
struct Fraction {
  Integer numerator, denominator;
};
Fraction fraction_of(const Quotient& q, std::int64_t times_two_to) {
  const std::int64_t exponent = q.exponent + times_two_to;
  if (exponent >= 0) return {shifted_left(q.numerator, exponent), q.denominator};
  return {q.numerator, shifted_left(q.denominator, -exponent)};
}

/// The nearest whole number to a fraction, ties to even.
Integer rounded(const Fraction& fraction) {
  Integer below, rest;
  mpz_fdiv_qr(below.get_mpz_t(), rest.get_mpz_t(), fraction.numerator.get_mpz_t(), fraction.denominator.get_mpz_t());
  rest *= 2;
  const int side = cmp(rest, fraction.denominator);
  if (side > 0 || (side == 0 && mpz_odd_p(below.get_mpz_t()) != 0)) ++below;
  return below;
}

/// floor(log2 |q|) or one more.
std::int64_t size_of(const Quotient& q) {
  return static_cast<std::int64_t>(mpz_sizeinbase(q.numerator.get_mpz_t(), 2)) -
         static_cast<std::int64_t>(mpz_sizeinbase(q.denominator.get_mpz_t(), 2)) + q.exponent;
}

}  // namespace

Dyadic dyadic(double finite) noexcept {
  if (finite == 0) return {};
  int exponent = 0;
  auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(finite, &exponent), 53));
  exponent -= 53;
  while ((mantissa & 1) == 0) {
    mantissa /= 2;
    ++exponent;
  }
  return {mantissa, exponent};
}

Integer in_units(const Dyadic& d, int unit) {
  if (d.mantissa == 0) return 0;
  return shifted_left(Integer(static_cast<long>(d.mantissa)), d.exponent - unit);
}

std::int64_t nearest_whole(const Quotient& q, std::int64_t limit) {
  const Integer whole = rounded(fraction_of(q, 0));
  if (whole > limit) return limit;
  if (whole < -limit) return -limit;
  return whole.get_si();
}

float nearest_float(const Quotient& q) {
  if (sgn(q.numerator) == 0) return 0;
  // In units of the float's last bit it has 24 bits; or 23, where size_of was one too many.
  std::int64_t unit = std::max<std::int64_t>(size_of(q) - 23, -149);
  Fraction fraction = fraction_of(q, -unit);
  const Integer least = Integer(1) << 23;
  if (unit > -149 && abs(fraction.numerator) < least * fraction.denominator) fraction = fraction_of(q, -(--unit));
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (unit > 104) return sgn(q.numerator) > 0 ? kInfinity : -kInfinity;
  return std::ldexp(static_cast<float>(rounded(fraction).get_si()), static_cast<int>(unit));
}

double approximately(const Quotient& q) {
  if (sgn(q.numerator) == 0) return 0;
  const std::int64_t unit = size_of(q) - 60;
  return std::ldexp(rounded(fraction_of(q, -unit)).get_d(), static_cast<int>(unit));
}

}  // namespace tuberia::rational
