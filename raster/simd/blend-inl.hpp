// Blending and the formats of colour: how a group of colours becomes pixels.

#if defined(TUBERIA_RASTER_SIMD_BLEND_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_BLEND_INL
#undef TUBERIA_RASTER_SIMD_BLEND_INL
#else
#define TUBERIA_RASTER_SIMD_BLEND_INL
#endif

#include "math/colour.hpp"
#include "raster/simd/bytes-inl.hpp"
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

/// The code of a colour in [0, 1], or above by as little as roundings bring about: 1/1000 would do.
template <class F>
HWY_INLINE Int encode(Vec4<F> c, ColourFormat format) {
  if (format == ColourFormat::srgb8) return pack(srgb_code(c.x), srgb_code(c.y), srgb_code(c.z), unorm8(c.w));
  return rounded_bytes(Vec4<F>(c.x * 255.0f, c.y * 255.0f, c.z * 255.0f, c.w * 255.0f));
}

template <class F>
HWY_INLINE Vec4<F> decode(Int pixel, ColourFormat format) {
  constexpr float kUnit = 1.0f / 255.0f;
  if (format == ColourFormat::rgba8) return scaled_bytes<F>(pixel, kUnit);
  const Int byte(0xff);
  const float* linear = linear_from_srgb_codes().data();
  return {gather<F>(linear, pixel & byte), gather<F>(linear, shift_right<8>(pixel) & byte),
          gather<F>(linear, shift_right<16>(pixel) & byte), to_float<F>(shift_right<24>(pixel)) * kUnit};
}

/// A colour that is to lie over others: what it adds, and what it leaves of them.
template <class F>
struct Layer {
  Vec4<F> light;
  F rest;
};

template <class F>
HWY_INLINE Layer<F> layer_of(Vec4<F> source) {
  return {{source.x * source.w, source.y * source.w, source.z * source.w, source.w}, 1.0f - source.w};
}
template <class F>
HWY_INLINE Vec4<F> over(const Layer<F>& layer, Vec4<F> pixel) {
  return {mul_add(pixel.x, layer.rest, layer.light.x), mul_add(pixel.y, layer.rest, layer.light.y),
          mul_add(pixel.z, layer.rest, layer.light.z), mul_add(pixel.w, layer.rest, layer.light.w)};
}

/// The new pixel from a fragment's colour and the pixel's.
template <class F>
HWY_INLINE Vec4<F> blend(Vec4<F> source, Vec4<F> pixel, BlendMode mode) {
  return mode == BlendMode::additive ? source + pixel : over(layer_of(source), pixel);
}

/// The codes of a layer over pixels with these codes; formats of 8 bits a channel. What comes of a
/// layer and a pixel in [0, 1] is below 1.000001 and not below 0, which its code does not show.
template <class F>
HWY_INLINE Int over(const Layer<F>& layer, Int codes, ColourFormat format) {
  return encode(over(layer, decode<F>(codes, format)), format);
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
  if (state.blend.mode == BlendMode::source_over)
    return store_where(live, over(layer_of(colour), load(pixels), state.colour_format), pixels);
  if (state.blend.mode == BlendMode::additive) {
    const Vec4<F> sum = colour + decode<F>(load(pixels), state.colour_format);
    colour = {min(sum.x, 1.0f), min(sum.y, 1.0f), min(sum.z, 1.0f), min(sum.w, 1.0f)};
  }
  store_where(live, encode(colour, state.colour_format), pixels);
}

/// The same for the pixels of a block. A function of its own, so that its loop has all registers.
template <ColourFormat kFormat, class F>
HWY_NOINLINE void lay_over_block(const Layer<F>& layer, std::uint32_t* pixels) {
  const Layer<F> same = layer;
  for (int i = 0; i < kBlockPixels; i += kLanes) store(over(same, load(pixels + i), kFormat), pixels + i);
}

/// write_colour for fragments that all have one colour, as far as that can be done beforehand.
template <class F>
class OneColour {
 public:
  HWY_INLINE void begin(Vec4<F> colour, const OutputState& state) {
    way_ = Way::none;
    if (state.colour_format == ColourFormat::rgba32f || state.blend.mode == BlendMode::additive) return;
    way_ = state.blend.mode == BlendMode::replace ? Way::replace : Way::lay_over;
    if (way_ == Way::replace) pixel_ = encode(saturate(colour), state.colour_format);
    else layer_ = layer_of(saturate(colour));
  }
  /// Whether write() may be called instead of write_colour().
  HWY_INLINE bool is_ready() const { return way_ != Way::none; }
  HWY_INLINE void write(Mask live, ColourFormat format, std::uint32_t* pixels) const {
    store_where(live, codes(format, pixels), pixels);
  }
  /// The same for a whole block.
  HWY_INLINE void write_block(ColourFormat format, std::uint32_t* pixels) const {
    if (way_ == Way::replace) {
      for (int i = 0; i < kBlockPixels; i += kLanes) store(pixel_, pixels + i);
    } else if (format == ColourFormat::rgba8) {
      lay_over_block<ColourFormat::rgba8>(layer_, pixels);
    } else {
      lay_over_block<ColourFormat::srgb8>(layer_, pixels);
    }
  }

 private:
  HWY_INLINE Int codes(ColourFormat format, const std::uint32_t* pixels) const {
    return way_ == Way::replace ? pixel_ : over(layer_, load(pixels), format);
  }

  enum class Way { none, replace, lay_over };
  Way way_ = Way::none;
  Int pixel_;
  Layer<F> layer_;
};

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
