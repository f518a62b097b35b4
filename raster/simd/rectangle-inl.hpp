// One mipmap level of a rectangle of 8-bit codes, the everyday texture: the texels around a point and
// their mean.

#if defined(TUBERIA_RASTER_SIMD_RECTANGLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_RECTANGLE_INL
#undef TUBERIA_RASTER_SIMD_RECTANGLE_INL
#else
#define TUBERIA_RASTER_SIMD_RECTANGLE_INL
#endif

#include "raster/simd/texel-inl.hpp"
#include "raster/simd/texel_fetch-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// A texture of 8-bit codes, and how it is read.
struct CodeReader {
  const Texture& texture;
  const Sampler& sampler;

  HWY_INLINE bool has_border() const { return sampler.wrap_u == Wrap::border || sampler.wrap_v == Wrap::border; }
};

/// Texels as they are filtered, at columns and rows that may lie one beyond the level.
template <class F>
HWY_INLINE Vec4<F> wrapped_texels(const CodeReader& from, const TextureLevel& level, Int column, Int row) {
  const Int x = wrap_index(column, level.width, from.sampler.wrap_u), y = wrap_index(row, level.height, from.sampler.wrap_v);
  const Int last_x(level.width - 1), last_y(level.height - 1);
  const Int index = max(min(y, last_y), Int(0)) * Int(level.width) + max(min(x, last_x), Int(0));
  const Vec4<F> inner = channels<F>(texels_at(level.texels, index), from.texture.encoding());
  if (!from.has_border()) return inner;
  const Mask outside = (x < Int(0)) | (x > last_x) | (y < Int(0)) | (y > last_y);
  const float colour_scale = from.texture.encoding() == TextureEncoding::srgb ? 1.0f : 255.0f;
  const Rgba32F& border = from.sampler.border;
  return {select(outside, F(border.r * colour_scale), inner.x), select(outside, F(border.g * colour_scale), inner.y),
          select(outside, F(border.b * colour_scale), inner.z), select(outside, F(border.a * 255.0f), inner.w)};
}

/// The texels around each lane's point, (x, y) in texels of the level, whatever there is beyond its edges.
template <class F>
HWY_NOINLINE Vec4<F> wrapped_mean(const CodeReader& from, const TextureLevel& level, F x, F y) {
  const F left = floor(x - 0.5f), top = floor(y - 0.5f);
  const F weight_x = (x - 0.5f) - left, weight_y = (y - 0.5f) - top;
  const Int column = truncate_to_int(left), row = truncate_to_int(top);
  const auto mean_of_row = [&](Int number) HWY_ATTR {
    return mix(wrapped_texels<F>(from, level, column, number), wrapped_texels<F>(from, level, column + Int(1), number), weight_x);
  };
  return intensities(mix(mean_of_row(row), mean_of_row(row + Int(1)), weight_y), from.texture.encoding());
}

template <class F>
HWY_NOINLINE Vec4<F> wrapped_nearest(const CodeReader& from, const TextureLevel& level, F x, F y) {
  return intensities(wrapped_texels<F>(from, level, truncate_to_int(floor(x)), truncate_to_int(floor(y))), from.texture.encoding());
}

/// The four texels that each lane's point lies between.
struct FourTexels {
  TexelPairs upper, lower;
};

/// Channel kChannel of the mean of four texels, as an intensity. Between codes the difference is
/// taken of the integers: it is as exact as the floats'.
template <int kChannel, class F>
HWY_INLINE F mean_of_codes(const FourTexels& texels, F weight_x, F weight_y) {
  const auto mean_of_row = [&](const TexelPairs& pair) HWY_ATTR {
    const Int left = byte<kChannel>(pair.left), step = byte<kChannel>(pair.right) - left;
    return mul_add(to_float<F>(step), weight_x, to_float<F>(left));
  };
  return mix(mean_of_row(texels.upper), mean_of_row(texels.lower), weight_y) * (1.0f / 255.0f);
}

template <int kChannel, class F>
HWY_INLINE F mean_of_intensities(const FourTexels& texels, F weight_x, F weight_y) {
  const auto mean_of_row = [&](const TexelPairs& pair) HWY_ATTR {
    return mix(linear_from_srgb<F>(byte<kChannel>(pair.left)), linear_from_srgb<F>(byte<kChannel>(pair.right)), weight_x);
  };
  return mix(mean_of_row(texels.upper), mean_of_row(texels.lower), weight_y);
}

template <class F>
HWY_INLINE Vec4<F> mean_of(const FourTexels& texels, F weight_x, F weight_y, TextureEncoding encoding) {
  const F alpha = mean_of_codes<3>(texels, weight_x, weight_y);
  if (encoding == TextureEncoding::linear)
    return {mean_of_codes<0>(texels, weight_x, weight_y), mean_of_codes<1>(texels, weight_x, weight_y),
            mean_of_codes<2>(texels, weight_x, weight_y), alpha};
  return {mean_of_intensities<0>(texels, weight_x, weight_y), mean_of_intensities<1>(texels, weight_x, weight_y),
          mean_of_intensities<2>(texels, weight_x, weight_y), alpha};
}

/// The four texels around (x, y), in texels of the level, by their distances. The way that is nearly
/// always possible: all four are there, and those of a row are neighbours in memory.
template <class F>
HWY_INLINE Vec4<F> bilinear_texels(const CodeReader& from, const TextureLevel& level, F x, F y, Mask live) {
  // Texel centres lie at +0.5: the four begin at floor(x - 0.5).
  const F left = floor(x - 0.5f), top = floor(y - 0.5f);
  const Int column = truncate_to_int(left), row = truncate_to_int(top);
  const Mask outside = is_negative(column | (Int(level.width - 2) - column) | row | (Int(level.height - 2) - row));
  if (any(outside & live)) return wrapped_mean(from, level, x, y);
  const IndexPairs index(select(outside, Int(0), row * Int(level.width) + column));
  const FourTexels texels{texel_pairs_at(level.texels, index), texel_pairs_at(level.texels + level.width, index)};
  return mean_of(texels, (x - 0.5f) - left, (y - 0.5f) - top, from.texture.encoding());
}

/// The texel that (x, y) lies in. Reduced coordinates leave a level without a border at its far end at most.
template <class F>
HWY_INLINE Vec4<F> nearest_texels(const CodeReader& from, const TextureLevel& level, F x, F y) {
  if (from.has_border()) return wrapped_nearest(from, level, x, y);
  const auto wrapped = [](F at, int size, Wrap wrap) HWY_ATTR {
    const Int last(size - 1), i = truncate_to_int(at);
    return select(i > last, wrap == Wrap::repeat ? Int(0) : last, i);
  };
  const Int column = wrapped(x, level.width, from.sampler.wrap_u), row = wrapped(y, level.height, from.sampler.wrap_v);
  const Int codes = texels_at(level.texels, row * Int(level.width) + column);
  return intensities(channels<F>(codes, from.texture.encoding()), from.texture.encoding());
}

/// One level, by the sampler's texel filter, at coordinates that have been reduced.
template <class F>
HWY_INLINE Vec4<F> sample_level(const CodeReader& from, int number, F u, F v, Mask live) {
  const TextureLevel& level = from.texture.level(number);
  const F x = u * static_cast<float>(level.width), y = v * static_cast<float>(level.height);
  if (from.sampler.texels == TexelFilter::nearest) return nearest_texels(from, level, x, y);
  return bilinear_texels(from, level, x, y, live);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
