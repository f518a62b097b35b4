// What all kinds of texture have in common: where a coordinate falls, what a texel's code means, and
// how the levels of detail are mixed.

#if defined(TUBERIA_RASTER_SIMD_TEXEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_TEXEL_INL
#undef TUBERIA_RASTER_SIMD_TEXEL_INL
#else
#define TUBERIA_RASTER_SIMD_TEXEL_INL
#endif

#include <bit>

#include "math/colour.hpp"
#include "raster/sampler.hpp"
#include "raster/simd/elementary-inl.hpp"
#include "raster/simd/texel_fetch-inl.hpp"
#include "raster/simd/vector-inl.hpp"
#include "raster/texture.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Into the texture's own [0, 1], before scaling, so that no float can address outside: numbers
/// that are not finite land somewhere in it. For `border`, into [-1, 2].                          [rules T2]
template <class F>
HWY_INLINE F reduce_coordinate(F u, Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat: return positive_part(u - floor(u));  // never above 1
    case Wrap::mirror: {
      const F half = u * 0.5f;
      const F period = saturate(half - floor(half)) * 2.0f;  // [0, 2]
      return min(period, 2.0f - period);
    }
    case Wrap::clamp: return saturate(u);
    case Wrap::border: break;
  }
  return min(select(u > -1.0f, u, F(-1.0f)), F(2.0f));
}

/// The index of a texel's neighbour across the texture's end: 0 <= result < size, except that
/// `border` keeps what lies outside.
HWY_INLINE Int wrap_index(Int i, int size, Wrap wrap) {
  if (wrap == Wrap::border) return i;
  const Int last(size - 1);
  if (wrap == Wrap::repeat) return select(i < Int(0), last, select(i > last, Int(0), i));
  return max(min(i, last), Int(0));
}

template <class F>
HWY_INLINE F linear_from_srgb(Int code) { return gather<F>(linear_from_srgb_codes().data(), code); }

/// A texel's weight in [0, 1) as the sampler has it.
template <class F>
HWY_INLINE F filter_weight(F weight, const Sampler& sampler) {
  return sampler.weights == FilterWeights::eight_bits ? floor(weight * 256.0f + 0.5f) * (1.0f / 256.0f) : weight;
}

/// The square of the longer half axis of the ellipse that a pixel's steps x and y span, of their dot
/// products: the larger singular value of the matrix of both. Beyond all floats the longer step decides.
template <class F>
HWY_INLINE F squared_longer_axis(F x_x, F x_y, F y_y) {
  const F half = (x_x - y_y) * 0.5f;
  const F sum = (x_x + y_y) * 0.5f + sqrt(half * half + x_y * x_y);
  return select(sum <= 3.4028235e38f, sum, max(x_x, y_y));
}

/// Channels of texels as they are filtered: codes, 0..255, or linear intensities when the codes are sRGB.
template <class F>
HWY_INLINE Vec4<F> channels(Int codes, TextureEncoding encoding) {
  const Int r = byte<0>(codes), g = byte<1>(codes), b = byte<2>(codes);
  const F alpha = to_float<F>(byte<3>(codes));
  if (encoding == TextureEncoding::linear) return {to_float<F>(r), to_float<F>(g), to_float<F>(b), alpha};
  return {linear_from_srgb<F>(r), linear_from_srgb<F>(g), linear_from_srgb<F>(b), alpha};
}

/// Codes to intensities; sRGB codes have already become intensities.
template <class F>
HWY_INLINE Vec4<F> intensities(Vec4<F> c, TextureEncoding encoding) {
  const F unit(1.0f / 255.0f);
  if (encoding == TextureEncoding::srgb) return {c.x, c.y, c.z, c.w * unit};
  return c * unit;
}

/// Each lane from its own level: a round for every level that occurs among the live lanes, which
/// are one or two nearly always. at_level(i, lanes) is the colour at level i; other lanes mean nothing.
template <class F, class AtLevel>
HWY_INLINE Vec4<F> sample_levels(Int levels, Mask live, const AtLevel& at_level) {
  alignas(64) std::int32_t level_of_lane[kLanes];
  store(levels, level_of_lane);
  Vec4<F> result{F(0.0f), F(0.0f), F(0.0f), F(0.0f)};
  Mask to_do = live;
  while (any(to_do)) {
    const int level = level_of_lane[std::countr_zero(bits_of(to_do))];
    const Mask here = levels == Int(level);
    const Vec4<F> colour = at_level(level, here);
    if (none(live & !here)) return colour;
    result = {select(here, colour.x, result.x), select(here, colour.y, result.y),
              select(here, colour.z, result.z), select(here, colour.w, result.w)};
    to_do = to_do & !here;
  }
  return result;
}

/// The sampler's bound on the level of detail, within the levels that there are; not-a-number is 0.
HWY_INLINE float bounded_level(float level, int last) {
  return level > 0 ? (level < static_cast<float>(last) ? level : static_cast<float>(last)) : 0.0f;
}

/// Mixes levels by the sampler's mipmap filter, which is not `none`, at an unbounded level of detail
/// that the bias has still to be added to.                                            [rules T3]
template <class F, class AtLevel>
HWY_INLINE Vec4<F> mix_levels(const Texture& texture, const Sampler& sampler, F level_of_detail, Mask live, const AtLevel& at_level) {
  const int last = texture.level_count() - 1;
  const F least(bounded_level(sampler.min_lod, last)), most(bounded_level(sampler.max_lod, last));
  const F unbounded = level_of_detail + sampler.lod_bias;
  const F lod = min(select(unbounded > least, unbounded, least), most);
  if (sampler.mipmaps == MipmapFilter::nearest) {
    // ceil(lod + 1/2) - 1, without ceil: halfway cases take the finer level.
    const Int level = truncate_to_int(-floor(-(lod + 0.5f)) - 1.0f);
    return sample_levels<F>(level, live, at_level);
  }
  const F fine = floor(lod);
  const F weight = lod - fine;
  const Int fine_level = truncate_to_int(fine);
  const Vec4<F> finer = sample_levels<F>(fine_level, live, at_level);
  if (none((weight > 0.0f) & live)) return finer;
  const Vec4<F> coarser = sample_levels<F>(min(fine_level + Int(1), Int(last)), live, at_level);
  return mix(finer, coarser, weight);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
