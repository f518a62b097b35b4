// Four bytes a lane: how the codes of a pixel's channels become floats, and floats become codes.

#if defined(TUBERIA_RASTER_SIMD_BYTES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_BYTES_INL
#undef TUBERIA_RASTER_SIMD_BYTES_INL
#else
#define TUBERIA_RASTER_SIMD_BYTES_INL
#endif

#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// float(a & mask) * scale, for masks of up to 23 bits: one rounding, the product's.
template <class F>
HWY_INLINE F scaled_bits(Int a, std::int32_t mask, float scale) {
#if HWY_TARGET == HWY_AVX3
  // Bits pasted below the exponent of 2^23 are a float that is so much too large. Taken off in the
  // product's own rounding, that costs nothing: 2^23 times a float is exact.
  const auto pasted = _mm512_ternarylogic_epi32(a.v.raw, Int(mask).v.raw, Int(0x4b000000).v.raw, 0xea);  // a & mask | 0x4b..
  return F(hn::MulAdd(float_of_bits<F>(Int(hn::Vec<IntTag>{pasted})).v, F(scale).v, F(-0x1p23f * scale).v));
#else
  return to_float<F>(a & Int(mask)) * scale;
#endif
}

/// The four bytes of each lane times a power of two or any other scale: byte 0 is x, byte 3 is w.
template <class F>
HWY_INLINE Vec4<F> scaled_bytes(Int bytes, float scale) {
  const Int upper = shift_right<16>(bytes);
  const float scale_of_second = scale * 0x1p-8f;  // of bytes that stay where they are, 8 bits too high
  return {scaled_bits<F>(bytes, 0xff, scale), scaled_bits<F>(bytes, 0xff00, scale_of_second),
          scaled_bits<F>(upper, 0xff, scale), scaled_bits<F>(upper, 0xff00, scale_of_second)};
}

/// Bytes 0 to 3 of each lane from four numbers 0..255.
HWY_INLINE Int pack(Int r, Int g, Int b, Int a) {
  return r | shift_left<8>(g) | shift_left<16>(b) | shift_left<24>(a);
}

#if HWY_TARGET == HWY_AVX3
/// Bits kBit to kBit + 7 hold floor(a + 1/2), 0 <= a < 255.5; those below and above are waste. The sum
/// with 2^(23 - kBit) + 1/2 has them there, and rounding towards zero keeps it from reaching the next number.
template <int kBit, Precision P>
HWY_INLINE Int rounded_at(Float<P> a) {
  static_assert(kBit >= 1 && kBit <= 15, "the 1/2 and a code of eight bits must find room");
  constexpr float kPlace = static_cast<float>(1 << (23 - kBit)) + 0.5f;
  return bits_of(Float<P>(hn::Vec<FloatTag>{_mm512_add_round_ps(a.v.raw, Float<P>(kPlace).v.raw, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC)}));
}
HWY_INLINE Int select_bits(std::int32_t mask, Int yes, Int no) {
  return Int(hn::Vec<IntTag>{_mm512_ternarylogic_epi32(yes.v.raw, no.v.raw, Int(mask).v.raw, 0xe4)});
}
#endif

/// floor(c + 1/2) of all four, 0 <= c < 255.5, as the bytes of each lane.
template <class F>
HWY_INLINE Int rounded_bytes(Vec4<F> c) {
#if HWY_TARGET == HWY_AVX3
  // Two neighbours leave each other's bits alone, so one choice by bits joins them.
  const Int lower = select_bits(0x1ff, rounded_at<1>(c.x), rounded_at<9>(c.y));
  const Int upper = select_bits(0x1ff, rounded_at<1>(c.z), rounded_at<9>(c.w));
  return select_bits(0xffff, shift_right<1>(lower), shift_left<15>(upper));
#else
  return pack(round_half_up(c.x), round_half_up(c.y), round_half_up(c.z), round_half_up(c.w));
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
