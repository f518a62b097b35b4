// Blending and the formats of colour: how a group of colours becomes pixels.

#if defined(TUBERIA_RASTER_SIMD_BLEND_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_BLEND_INL
#undef TUBERIA_RASTER_SIMD_BLEND_INL
#else
#define TUBERIA_RASTER_SIMD_BLEND_INL
#endif

#include "math/colour.hpp"
#include "raster/simd/vector-inl.hpp"
#include "raster/srgb_encoding.hpp"
#include "raster/tile.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

template <class F>
HWY_INLINE Vec4<F> saturate(Vec4<F> c) { return {saturate(c.x), saturate(c.y), saturate(c.z), saturate(c.w)}; }

/// floor(255 x + 1/2) of x in [0, 1].                                                   [rules B1]
template <class F>
HWY_INLINE Int unorm8(F x) { return round_half_up(x * 255.0f); }

HWY_INLINE Int pack(Int r, Int g, Int b, Int a) {
  return r | shift_left<8>(g) | shift_left<16>(b) | shift_left<24>(a);
}

/// The nearest sRGB code of a linear intensity in [0, 1]: a first guess by exponent and leading
/// bits of the mantissa, right or one too small, then one comparison.
template <class F>
HWY_INLINE Int srgb_code(F linear) {
  const SrgbEncoding& table = srgb_encoding();
  const F at_least = max(linear, SrgbEncoding::kSmallest);
  const Int bucket = shift_right<SrgbEncoding::kShift>(bits_of(at_least)) - Int(SrgbEncoding::kFirstBucket);
  const Int guess = gather(table.code_of_bucket.data(), bucket);
  const F next = gather<F>(table.threshold.data(), guess + Int(1));
  return guess + (Int(1) & select(at_least >= next, Int(-1), Int(0)));
}

template <class F>
HWY_INLINE Int encode(Vec4<F> c, ColourFormat format) {
  if (format == ColourFormat::srgb8) return pack(srgb_code(c.x), srgb_code(c.y), srgb_code(c.z), unorm8(c.w));
  return pack(unorm8(c.x), unorm8(c.y), unorm8(c.z), unorm8(c.w));
}

template <class F>
HWY_INLINE Vec4<F> decode(Int pixel, ColourFormat format) {
  const Int byte(0xff);
  const F unit(1.0f / 255.0f);
  const Int r = pixel & byte, g = shift_right<8>(pixel) & byte, b = shift_right<16>(pixel) & byte;
  const F alpha = to_float<F>(shift_right<24>(pixel)) * unit;
  if (format == ColourFormat::rgba8) return {to_float<F>(r) * unit, to_float<F>(g) * unit, to_float<F>(b) * unit, alpha};
  const float* linear = linear_from_srgb_codes().data();
  return {gather<F>(linear, r), gather<F>(linear, g), gather<F>(linear, b), alpha};
}

/// The new pixel from a fragment's colour and the pixel's.
template <class F>
HWY_INLINE Vec4<F> blend(Vec4<F> source, Vec4<F> pixel, BlendMode mode) {
  if (mode == BlendMode::additive) return source + pixel;
  const F rest = 1.0f - source.w;
  return {mul_add(pixel.x, rest, source.x * source.w), mul_add(pixel.y, rest, source.y * source.w),
          mul_add(pixel.z, rest, source.z * source.w), mul_add(pixel.w, rest, source.w)};
}

/// Blends and stores the live fragments at `index` of the tile's colours.
template <class F>
HWY_INLINE void write_colour(Mask live, Vec4<F> colour, const OutputState& state, void* tile_colour, int index) {
  if (state.colour_format == ColourFormat::rgba32f) {
    // Planes of a block: the floats of a group of one channel lie together.
    float* first = static_cast<float*>(tile_colour) + index / kBlockPixels * (4 * kBlockPixels) + index % kBlockPixels;
    float* planes[4] = {first, first + kBlockPixels, first + 2 * kBlockPixels, first + 3 * kBlockPixels};
    if (state.blend.mode != BlendMode::replace)
      colour = blend(colour, Vec4<F>{load<F>(planes[0]), load<F>(planes[1]), load<F>(planes[2]), load<F>(planes[3])},
                     state.blend.mode);
    store_where(live, colour.x, planes[0]);
    store_where(live, colour.y, planes[1]);
    store_where(live, colour.z, planes[2]);
    store_where(live, colour.w, planes[3]);
    return;
  }

  std::uint32_t* pixels = static_cast<std::uint32_t*>(tile_colour) + index;
  colour = saturate(colour);
  if (state.blend.mode != BlendMode::replace)
    colour = saturate(blend(colour, decode<F>(load(pixels), state.colour_format), state.blend.mode));
  store_where(live, encode(colour, state.colour_format), pixels);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
