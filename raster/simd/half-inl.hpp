// A register of floats to 16-bit floats and back, as raster/half_float.hpp does with one.

#if defined(TUBERIA_RASTER_SIMD_HALF_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_HALF_INL
#undef TUBERIA_RASTER_SIMD_HALF_INL
#else
#define TUBERIA_RASTER_SIMD_HALF_INL
#endif

#include "raster/simd/number-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// The codes of the nearest halves, in the lower 16 bits. Additions of integers alone, but for the
/// small ones: machines that convert by themselves disagree about what is not a number.
template <class F>
HWY_INLINE Int half_code(F value) {
  const Int bits = bits_of(value);
  const Int magnitude = bits & Int(0x7fffffff);
  const Int sign = shift_left<15>(shift_right<31>(bits));
  const Int small = bits_of(float_of_bits<F>(magnitude) + 0.5f) - Int(0x3f000000);
  const Int odd = shift_right<13>(magnitude) & Int(1);
  const Int normal = shift_right<13>(magnitude - Int((112 << 23) - 0xfff) + odd);
  Int code = select(magnitude < Int(0x38800000), small, normal);
  code = select(magnitude < Int(0x47800000), code, Int(0x7c00)) | sign;
  return select(magnitude > Int(0x7f800000), Int(0x7e00), code);
}

template <class F>
HWY_INLINE F float_of_half(Int code) {
  const Int magnitude = code & Int(0x7fff);
  const Int sign = shift_left<16>(code & Int(0x8000));
  const Int small = bits_of(to_float<F>(magnitude) * 0x1p-24f);
  const Int shift = select(magnitude < Int(0x7c00), Int(112 << 23), Int(224 << 23));
  const Int normal = shift_left<13>(magnitude) + shift;
  return float_of_bits<F>(select(magnitude < Int(0x400), small, normal) | sign);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
