// Elementary functions from additions, multiplications and divisions alone: the C library's differ
// from machine to machine, these do not.

#if defined(TUBERIA_RASTER_SIMD_ELEMENTARY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_ELEMENTARY_INL
#undef TUBERIA_RASTER_SIMD_ELEMENTARY_INL
#else
#define TUBERIA_RASTER_SIMD_ELEMENTARY_INL
#endif

#include "raster/simd/number-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// What these functions compute with: all of fast, or none of it.
template <class F>
using Elementary = Float<contains(F::kPrecision, Precision::fast_power) ? Precision::fast : Precision::exact>;

/// Logarithm to base 2 of a normal number a > 0; anything else counts as the smallest normal number.
/// Largest relative error 3e-7; fast 4e-7, next to 1 on machines that cannot fuse (precision_test).
template <class Any>
HWY_INLINE Any log2(Any number) {
  using F = Elementary<Any>;
  const F a(number.v);
  // a = 2^exponent * mantissa with the mantissa in [sqrt(1/2), sqrt(2)), so that a near 1 has
  // exponent 0 and keeps its relative precision.
  constexpr std::int32_t kBitsOfRootHalf = 0x3f3504f3;
  const F normal = min(select(a > 1.17549435e-38f, a, F(1.17549435e-38f)), F(3.4028235e38f));
  const Int above = bits_of(normal) - Int(kBitsOfRootHalf);
  const Int exponent_bits = above & Int(static_cast<std::int32_t>(0xff800000));
  const F mantissa = float_of_bits<F>(bits_of(normal) - exponent_bits);
  const F exponent = to_float<F>(exponent_bits) * 1.1920929e-7f;  // 2^-23: the shift, sign kept

  // log2(m) = 2/ln(2) * atanh(s), s = (m-1)/(m+1), |s| < 0.172; the series' sixth term is below 1e-9.
  const F s = (mantissa - 1.0f) * reciprocal(mantissa + 1.0f);
  const F square = s * s;
  F series(0.32059890f);                                   // 2 / (9 ln 2)
  series = mul_add(series, square, F(0.41219859f));        // 2 / (7 ln 2)
  series = mul_add(series, square, F(0.57707802f));        // 2 / (5 ln 2)
  series = mul_add(series, square, F(0.96179669f));        // 2 / (3 ln 2)
  series = mul_add(series, square, F(2.88539008f));        // 2 / ln 2
  return Any(mul_add(s, series, exponent).v);
}

/// 2^a. Below -126 the result is 0, above 127.49 it is 2^127.49 (so that the power of two below
/// stays finite); not-a-number gives 0.
/// Largest relative error 2e-7 on [-126, 127] (precision_test).
template <class Any>
HWY_INLINE Any exp2(Any number) {
  using F = Elementary<Any>;
  const F a(number.v);
  const F bounded = min(select(a > -127.0f, a, F(-127.0f)), F(127.49f));
  const F whole = floor(bounded + 0.5f);
  const F x = bounded - whole;  // in [-1/2, 1/2]; the Taylor series' next term is below 6e-9
  F series(1.5252734e-5f);      // ln(2)^7 / 7!
  series = mul_add(series, x, F(1.5403530e-4f));
  series = mul_add(series, x, F(1.3333558e-3f));
  series = mul_add(series, x, F(9.6181291e-3f));
  series = mul_add(series, x, F(5.5504109e-2f));
  series = mul_add(series, x, F(2.4022651e-1f));
  series = mul_add(series, x, F(6.9314718e-1f));
  series = mul_add(series, x, F(1.0f));
  const F power = float_of_bits<F>(shift_left<23>(truncate_to_int(whole) + Int(127)));
  return Any(select(a < -126.0f, F(0.0f), series * power).v);
}

/// base^exponent for base >= 0; a negative base counts as 0; 0^0 is 1.               [rules S2]
/// Largest relative error 3e-7 * (1 + |exponent * log2(base)|) (precision_test).
template <class F>
HWY_INLINE F pow(F base, F exponent) {
  const F power = exp2(exponent * log2(base));
  const F of_zero = select(exponent == 0.0f, F(1.0f), F(0.0f));
  return select(base > 0.0f, power, of_zero);
}

/// Sine and cosine of one angle.
template <class F>
struct SineCosine {
  F sine, cosine;
};

/// Of quarter turns plus a rest in radians, |rest| <= pi/4. Minimax polynomials: relative errors 4e-9
/// before rounding.
template <class F>
HWY_INLINE SineCosine<F> sine_cosine_of_quadrant(Int quarter_turns, F rest) {
  const F square = rest * rest;
  F sine(-1.95172347e-4f);
  sine = mul_add(sine, square, F(8.33217769e-3f));
  sine = mul_add(sine, square, F(-1.66666549e-1f));
  sine = mul_add(sine * square, rest, rest);
  F cosine(2.44330827e-5f);
  cosine = mul_add(cosine, square, F(-1.38873156e-3f));
  cosine = mul_add(cosine, square, F(4.16666457e-2f));
  cosine = mul_add(cosine * square, square, mul_add(square, F(-0.5f), F(1.0f)));

  const Mask exchanged = (quarter_turns & Int(1)) == Int(1);
  const F s = select(exchanged, cosine, sine), c = select(exchanged, sine, cosine);
  const Mask negative_sine = (quarter_turns & Int(2)) == Int(2);
  const Mask negative_cosine = ((quarter_turns + Int(1)) & Int(2)) == Int(2);
  return {select(negative_sine, -s, s), select(negative_cosine, -c, c)};
}

/// Sine and cosine of 2 pi times a number, which is reduced without error whatever its size; numbers that
/// are not finite count as 0. Largest error 1.2e-7 (precision_test).
template <class Any>
HWY_INLINE SineCosine<Any> sine_cosine_of_turns(Any number) {
  using F = Elementary<Any>;
  const F turns = select(abs(F(number.v)) <= 3.4028235e38f, F(number.v), F(0.0f));
  const F part = turns - floor(turns + 0.5f);  // [-1/2, 1/2], or a whole number
  const F quarters = floor(mul_add(part, F(4.0f), F(0.5f)));
  const F rest = (part - quarters * 0.25f) * 6.28318531f;
  const SineCosine<F> result = sine_cosine_of_quadrant(truncate_to_int(quarters), rest);
  return {Any(result.sine.v), Any(result.cosine.v)};
}

/// Sine and cosine of an angle in radians. Largest error 1.2e-7 for |a| <= 8192, where pi/2 is taken off
/// in three pieces of which the first two have so few digits that their multiples have no error; beyond
/// that 2.5e-7 |a|, from the one multiplication that makes turns of it. Angles that are not finite count as 0 (precision_test).
template <class Any>
HWY_INLINE SineCosine<Any> sine_cosine(Any number) {
  using F = Elementary<Any>;
  const F a(number.v);
  const Mask near = abs(a) <= 8192.0f;
  const F radians = select(near, a, F(0.0f));
  const F quarters = floor(mul_add(radians, F(0.636619772f), F(0.5f)));
  F rest = radians - quarters * 1.5703125f;                    // 8 digits of pi/2
  rest = rest - quarters * 4.837512969970703125e-4f;           // the next 11
  rest = rest - quarters * 7.54978995489188216e-8f;
  const SineCosine<F> result = sine_cosine_of_quadrant(truncate_to_int(quarters), rest);
  if (all(near)) return {Any(result.sine.v), Any(result.cosine.v)};
  const SineCosine<F> far = sine_cosine_of_turns(a * 0.159154943f);
  return {Any(select(near, result.sine, far.sine).v), Any(select(near, result.cosine, far.cosine).v)};
}
template <class F>
HWY_INLINE F sin(F radians) { return sine_cosine(radians).sine; }
template <class F>
HWY_INLINE F cos(F radians) { return sine_cosine(radians).cosine; }

/// Angle in [0, pi] with the cosine a; a is clamped to [-1, 1], not-a-number counts as -1.
/// Largest error 4e-7, relative to the result 4e-7 (precision_test).
template <class Any>
HWY_INLINE Any acos(Any number) {
  using F = Elementary<Any>;
  const F a = min(select(F(number.v) > -1.0f, F(number.v), F(-1.0f)), F(1.0f));
  // For large |a| by the half angle, acos(a) = 2 asin(sqrt((1 - a) / 2)), which loses no digits near 1.
  const F size = abs(a);
  const Mask large = size > 0.5f;
  const F square = select(large, (1.0f - size) * 0.5f, size * size);
  const F sine = select(large, sqrt(square), size);
  F series(4.21663320e-2f);  // minimax for |sine| <= 1/2, relative error 5e-9
  series = mul_add(series, square, F(2.41795003e-2f));
  series = mul_add(series, square, F(4.54703791e-2f));
  series = mul_add(series, square, F(7.49529762e-2f));
  series = mul_add(series, square, F(1.66667525e-1f));
  const F arc = mul_add(series * square, sine, sine);
  const Mask negative = a < 0.0f;
  const F of_small = 1.57079633f - select(negative, -arc, arc);
  const F of_large = select(negative, 3.14159265f - 2.0f * arc, 2.0f * arc);
  return Any(select(large, of_large, of_small).v);
}

/// Angle in [-pi, pi] of the direction (x, y), 0 for (0, 0). The sign of a zero does not count: a y of
/// either zero gives 0 or +pi. Infinite components count as the largest float, not-a-number as 0.
/// Largest error 4e-7, relative to the result 4e-7 where that is no denormal number (precision_test).
template <class Any>
HWY_INLINE Any atan2(Any ordinate, Any abscissa) {
  using F = Elementary<Any>;
  const F largest(3.4028235e38f);
  const F y(ordinate.v), x(abscissa.v);
  const F high = select(y == y, min(abs(y), largest), F(0.0f)), wide = select(x == x, min(abs(x), largest), F(0.0f));
  const F divisor = max(high, wide);
  const F ratio = min(high, wide) / select(divisor > 0.0f, divisor, F(1.0f));
  const F square = ratio * ratio;
  F series(2.92068799e-3f);  // minimax for 0..1, relative error 2e-8
  series = mul_add(series, square, F(-1.63679103e-2f));
  series = mul_add(series, square, F(4.32118306e-2f));
  series = mul_add(series, square, F(-7.55221156e-2f));
  series = mul_add(series, square, F(1.06660033e-1f));
  series = mul_add(series, square, F(-1.42110549e-1f));
  series = mul_add(series, square, F(1.99937728e-1f));
  series = mul_add(series, square, F(-3.33331527e-1f));
  const F arc = mul_add(series * square, ratio, ratio);
  const F in_first_quadrant = select(high > wide, 1.57079633f - arc, arc);
  const F in_half_plane = select(x < 0.0f, 3.14159265f - in_first_quadrant, in_first_quadrant);
  return Any(select(y < 0.0f, -in_half_plane, in_half_plane).v);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
