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

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
