// One mipmap level of a rectangle of 8-bit codes, the everyday texture: the texels around a point and
// their mean.

#if defined(TUBERIA_RASTER_SIMD_RECTANGLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_RECTANGLE_INL
#undef TUBERIA_RASTER_SIMD_RECTANGLE_INL
#else
#define TUBERIA_RASTER_SIMD_RECTANGLE_INL
#endif

#include "raster/simd/texel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// A texture of 8-bit codes, and how it is read.
struct CodeReader {
  const Texture& texture;
  const Sampler& sampler;

  HWY_INLINE bool has_border() const { return sampler.wrap_u == Wrap::border || sampler.wrap_v == Wrap::border; }
};

/// Texels as they are filtered, or the border's colour, at columns and rows that may lie one beyond the level.
template <class F>
HWY_INLINE Vec4<F> bordered_texels(const CodeReader& from, const TextureLevel& level, Int column, Int row) {
  const Int x = wrap_index(column, level.width, from.sampler.wrap_u), y = wrap_index(row, level.height, from.sampler.wrap_v);
  const Int last_x(level.width - 1), last_y(level.height - 1);
  const Mask outside = (x < Int(0)) | (x > last_x) | (y < Int(0)) | (y > last_y);
  const Int index = max(min(y, last_y), Int(0)) * Int(level.width) + max(min(x, last_x), Int(0));
  const Vec4<F> inner = channels<F>(texels_at(level.texels, index), from.texture.encoding());
  const float colour_scale = from.texture.encoding() == TextureEncoding::srgb ? 1.0f : 255.0f;
  const Rgba32F& border = from.sampler.border;
  return {select(outside, F(border.r * colour_scale), inner.x), select(outside, F(border.g * colour_scale), inner.y),
          select(outside, F(border.b * colour_scale), inner.z), select(outside, F(border.a * 255.0f), inner.w)};
}

template <class F>
HWY_NOINLINE Vec4<F> bordered_nearest(const CodeReader& from, const TextureLevel& level, F x, F y) {
  return intensities(bordered_texels<F>(from, level, truncate_to_int(floor(x)), truncate_to_int(floor(y))), from.texture.encoding());
}

/// The four texels around (u, v) in a level: it and its neighbours to the right and below.
template <class F>
struct BetweenTexels {
  const TextureLevel& level;
  F weight_x, weight_y;
  Int column, row;  // of the upper left texel; all may lie one beyond the level's ends
  Mask outside;     // where some do

  HWY_INLINE BetweenTexels(const TextureLevel& level_, F u, F v) : level(level_) {
    // Texel centres lie at +0.5.
    const F x = u * static_cast<float>(level.width) - 0.5f, y = v * static_cast<float>(level.height) - 0.5f;
    const F left = floor(x), top = floor(y);
    weight_x = x - left, weight_y = y - top;
    column = truncate_to_int(left), row = truncate_to_int(top);
    outside = is_negative(column | (Int(level.width - 2) - column) | row | (Int(level.height - 2) - row));
  }

  /// All four are there nearly always; then those of a row are neighbours in memory.
  HWY_INLINE bool are_there(Mask live) const { return none(outside & live); }
  HWY_INLINE FourTexels load() const {
    return squares_at(level.texels, level.width, select(outside, Int(0), row * Int(level.width) + column));
  }
};

template <class F>
HWY_NOINLINE Vec4<F> bordered_mean(const CodeReader& from, const TextureLevel& level, F u, F v) {
  const BetweenTexels<F> point(level, u, v);
  const auto mean_of_row = [&](Int row) HWY_ATTR {
    return mix(bordered_texels<F>(from, level, point.column, row), bordered_texels<F>(from, level, point.column + Int(1), row), point.weight_x);
  };
  return intensities(mix(mean_of_row(point.row), mean_of_row(point.row + Int(1)), point.weight_y), from.texture.encoding());
}

/// Channel kChannel of the mean of four texels, as an intensity. Between codes the difference is
/// taken of the integers: it is as exact as the floats'.
template <int kChannel, class F>
HWY_INLINE F mean_of_codes(const FourTexels& texels, F weight_x, F weight_y) {
  const auto mean_of_row = [&](Int left_codes, Int right_codes) HWY_ATTR {
    const Int left = byte<kChannel>(left_codes), step = byte<kChannel>(right_codes) - left;
    return mul_add(to_float<F>(step), weight_x, to_float<F>(left));
  };
  return mix(mean_of_row(texels.upper_left, texels.upper_right), mean_of_row(texels.lower_left, texels.lower_right), weight_y) * (1.0f / 255.0f);
}

template <int kChannel, class F>
HWY_INLINE F mean_of_intensities(const FourTexels& texels, F weight_x, F weight_y) {
  const auto mean_of_row = [&](Int left_codes, Int right_codes) HWY_ATTR {
    return mix(linear_from_srgb<F>(byte<kChannel>(left_codes)), linear_from_srgb<F>(byte<kChannel>(right_codes)), weight_x);
  };
  return mix(mean_of_row(texels.upper_left, texels.upper_right), mean_of_row(texels.lower_left, texels.lower_right), weight_y);
}

template <class F>
HWY_INLINE Vec4<F> mean_of(const FourTexels& texels, const BetweenTexels<F>& point, TextureEncoding encoding) {
  static_assert(255.0f * (1.0f / 255.0f) == 1.0f, "what the mean of opaque texels comes to");
  const F x = point.weight_x, y = point.weight_y;
  const F alpha = point.level.is_opaque ? F(1.0f) : mean_of_codes<3>(texels, x, y);
  if (encoding == TextureEncoding::linear) return {mean_of_codes<0>(texels, x, y), mean_of_codes<1>(texels, x, y), mean_of_codes<2>(texels, x, y), alpha};
  return {mean_of_intensities<0>(texels, x, y), mean_of_intensities<1>(texels, x, y), mean_of_intensities<2>(texels, x, y), alpha};
}

/// The mean of the four texels around (u, v), wherever they are.
template <class F>
HWY_NOINLINE Vec4<F> wrapped_mean(const CodeReader& from, const TextureLevel& level, F u, F v) {
  const auto& [texture, sampler] = from;
  const BetweenTexels<F> point(level, u, v);
  const Int left = wrap_index(point.column, level.width, sampler.wrap_u), right = wrap_index(point.column + Int(1), level.width, sampler.wrap_u);
  const Int upper = wrap_index(point.row, level.height, sampler.wrap_v) * Int(level.width);
  const Int lower = wrap_index(point.row + Int(1), level.height, sampler.wrap_v) * Int(level.width);
  const FourTexels texels{texels_at(level.texels, upper + left), texels_at(level.texels, upper + right),
                          texels_at(level.texels, lower + left), texels_at(level.texels, lower + right)};
  return mean_of(texels, point, texture.encoding());
}

template <class F>
HWY_INLINE Vec4<F> bilinear_texels(const CodeReader& from, const TextureLevel& level, F u, F v, Mask live) {
  const BetweenTexels<F> point(level, u, v);
  if (point.are_there(live)) return mean_of(point.load(), point, from.texture.encoding());
  return from.has_border() ? bordered_mean(from, level, u, v) : wrapped_mean(from, level, u, v);
}

/// The texel that (u, v) lies in. Reduced coordinates leave a level without a border at its far end at most.
template <class F>
HWY_INLINE Vec4<F> nearest_texels(const CodeReader& from, const TextureLevel& level, F u, F v) {
  const F x = u * static_cast<float>(level.width), y = v * static_cast<float>(level.height);
  if (from.has_border()) return bordered_nearest(from, level, x, y);
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
  if (from.sampler.texels == TexelFilter::nearest) return nearest_texels(from, level, u, v);
  return bilinear_texels(from, level, u, v, live);
}

template <class F>
HWY_NOINLINE Vec4<F> mix_levels_one_by_one(const CodeReader& from, int finer, F u, F v, F weight, std::uint32_t live) {
  const Vec4<F> colour = sample_level(from, finer, u, v, mask_of(live));
  return mix(colour, sample_level(from, finer + 1, u, v, mask_of(live)), weight);
}

/// A level and the next coarser one. Both are read before any mean is taken: while the texels of the one
/// are awaited, those of the other can be.
template <class F>
HWY_INLINE Vec4<F> mix_two_levels(const CodeReader& from, int finer, F u, F v, F weight, std::uint32_t live) {
  const BetweenTexels<F> fine(from.texture.level(finer), u, v), coarse(from.texture.level(finer + 1), u, v);
  const bool is_bilinear = from.sampler.texels == TexelFilter::bilinear;
  if (!is_bilinear || !fine.are_there(mask_of(live)) || !coarse.are_there(mask_of(live))) return mix_levels_one_by_one(from, finer, u, v, weight, live);
  const FourTexels fine_texels = fine.load(), coarse_texels = coarse.load();
  return mix(mean_of(fine_texels, fine, from.texture.encoding()), mean_of(coarse_texels, coarse, from.texture.encoding()), weight);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
