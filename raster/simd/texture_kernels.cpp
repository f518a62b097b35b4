// Texture sampling: coordinates to texels, filtering inside and between mipmap levels.

#include <bit>

#include "math/colour.hpp"
#include "raster/texture.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "raster/simd/texture_kernels.cpp"
#include "raster/simd/every_instruction_set.hpp"

#include "raster/simd/elementary-inl.hpp"
#include "raster/simd/texture-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Into the texture's own [0, 1], before scaling, so that no float can address outside: numbers
/// that are not finite land somewhere in it. For `border`, into [-1, 2].                          [rules T2]
template <class F>
HWY_INLINE F reduce_coordinate(F u, Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat: return saturate(u - floor(u));
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

/// Channels of four texels' codes, 0..255, or linear intensities when the codes are sRGB.
template <class F>
HWY_INLINE Vec4<F> channels(Int codes, TextureEncoding encoding) {
  const Int byte(0xff);
  const Int r = codes & byte, g = shift_right<8>(codes) & byte, b = shift_right<16>(codes) & byte;
  const F alpha = to_float<F>(shift_right<24>(codes));
  if (encoding == TextureEncoding::linear) return {to_float<F>(r), to_float<F>(g), to_float<F>(b), alpha};
  const float* decode = linear_from_srgb_codes().data();
  return {gather<F>(decode, r), gather<F>(decode, g), gather<F>(decode, b), alpha};
}

/// Codes to intensities; sRGB codes have already become intensities.
template <class F>
HWY_INLINE Vec4<F> intensities(Vec4<F> c, TextureEncoding encoding) {
  const F unit(1.0f / 255.0f);
  if (encoding == TextureEncoding::srgb) return {c.x, c.y, c.z, c.w * unit};
  return c * unit;
}

template <class F>
HWY_INLINE Vec4<F> texels_at(const Texture& texture, const TextureLevel& level, Int x, Int y) {
  const auto* codes = reinterpret_cast<const std::int32_t*>(level.texels);
  return channels<F>(gather(codes, y * Int(level.width) + x), texture.encoding());
}

/// Texels, or the border's colour outside.
template <class F>
HWY_NOINLINE Vec4<F> texels_or_border(const Texture& texture, const TextureLevel& level, const Sampler& sampler,
                                      const Int& x, const Int& y) {
  const Int last_x(level.width - 1), last_y(level.height - 1);
  const Mask outside = (x < Int(0)) | (x > last_x) | (y < Int(0)) | (y > last_y);
  const Vec4<F> inner = texels_at<F>(texture, level, max(min(x, last_x), Int(0)), max(min(y, last_y), Int(0)));
  const float colour_scale = texture.encoding() == TextureEncoding::srgb ? 1.0f : 255.0f;
  const Rgba32F& border = sampler.border;
  return {select(outside, F(border.r * colour_scale), inner.x), select(outside, F(border.g * colour_scale), inner.y),
          select(outside, F(border.b * colour_scale), inner.z), select(outside, F(border.a * 255.0f), inner.w)};
}

template <class F>
HWY_INLINE Vec4<F> fetch(const Texture& texture, const TextureLevel& level, const Sampler& sampler, Int x, Int y) {
  if (sampler.wrap_u == Wrap::border || sampler.wrap_v == Wrap::border)
    return texels_or_border<F>(texture, level, sampler, x, y);
  return texels_at<F>(texture, level, x, y);
}

/// One level, by the sampler's texel filter.
template <class F>
HWY_NOINLINE Vec4<F> sample_level(const Texture& texture, int level_index, const Sampler& sampler, const Vec2<F>& uv) {
  const TextureLevel& level = texture.level(level_index);
  const F x = reduce_coordinate(uv.x, sampler.wrap_u) * static_cast<float>(level.width);
  const F y = reduce_coordinate(uv.y, sampler.wrap_v) * static_cast<float>(level.height);
  if (sampler.texels == TexelFilter::nearest) {
    const Int column = wrap_index(truncate_to_int(floor(x)), level.width, sampler.wrap_u);
    const Int row = wrap_index(truncate_to_int(floor(y)), level.height, sampler.wrap_v);
    return intensities(fetch<F>(texture, level, sampler, column, row), texture.encoding());
  }

  // Texel centres lie at +0.5: the four around (x, y) begin at floor(x - 0.5).
  const F left = floor(x - 0.5f), top = floor(y - 0.5f);
  const F weight_x = (x - 0.5f) - left, weight_y = (y - 0.5f) - top;
  const Int column = truncate_to_int(left), row = truncate_to_int(top);
  const Int x0 = wrap_index(column, level.width, sampler.wrap_u);
  const Int x1 = wrap_index(column + Int(1), level.width, sampler.wrap_u);
  const Int y0 = wrap_index(row, level.height, sampler.wrap_v);
  const Int y1 = wrap_index(row + Int(1), level.height, sampler.wrap_v);
  const Vec4<F> upper = mix(fetch<F>(texture, level, sampler, x0, y0), fetch<F>(texture, level, sampler, x1, y0), weight_x);
  const Vec4<F> lower = mix(fetch<F>(texture, level, sampler, x0, y1), fetch<F>(texture, level, sampler, x1, y1), weight_x);
  return intensities(mix(upper, lower, weight_y), texture.encoding());
}

/// Each lane from its own level: a round for every level that occurs among the live lanes, which
/// are one or two nearly always.
template <class F>
HWY_INLINE Vec4<F> sample_levels(const Texture& texture, Int levels, const Sampler& sampler, const Vec2<F>& uv, Mask live) {
  alignas(64) std::int32_t level_of_lane[kLanes];
  store(levels, level_of_lane);
  Vec4<F> result{F(0.0f), F(0.0f), F(0.0f), F(0.0f)};
  Mask to_do = live;
  while (any(to_do)) {
    const int level = level_of_lane[std::countr_zero(bits_of(to_do))];
    const Mask here = levels == Int(level);
    const Vec4<F> colour = sample_level(texture, level, sampler, uv);
    result = {select(here, colour.x, result.x), select(here, colour.y, result.y),
              select(here, colour.z, result.z), select(here, colour.w, result.w)};
    to_do = to_do & !here;
  }
  return result;
}

/// log2 of the texels of the base level that one pixel step crosses, the larger of the two
/// directions; one for each quad, from its upper left pixel.                         [rules T3]
template <class F>
HWY_INLINE F level_of_detail(const Texture& texture, Vec2<F> uv) {
  const F width(static_cast<float>(texture.level(0).width)), height(static_cast<float>(texture.level(0).height));
  const F u = uv.x * width, v = uv.y * height;
  const F du_dx = difference_x(u), dv_dx = difference_x(v), du_dy = difference_y(u), dv_dy = difference_y(v);
  const F squared = max(du_dx * du_dx + dv_dx * dv_dx, du_dy * du_dy + dv_dy * dv_dy);
  return log2(first_of_quad(squared)) * 0.5f;
}

template <class F>
HWY_INLINE Vec4<F> filtered(const Texture& texture, const Sampler& sampler, const Vec2<F>& uv, Mask live) {
  const int last = texture.level_count() - 1;
  if (sampler.mipmaps == MipmapFilter::none || last == 0) return sample_level(texture, 0, sampler, uv);

  const F unbounded = level_of_detail(texture, uv) + sampler.lod_bias;
  const F lod = min(select(unbounded > 0.0f, unbounded, F(0.0f)), F(static_cast<float>(last)));
  if (sampler.mipmaps == MipmapFilter::nearest) {
    // ceil(lod + 1/2) - 1, without ceil: halfway cases take the finer level.
    const Int level = truncate_to_int(-floor(-(lod + 0.5f)) - 1.0f);
    return sample_levels(texture, level, sampler, uv, live);
  }
  const F fine = floor(lod);
  const F weight = lod - fine;
  const Int fine_level = truncate_to_int(fine);
  const Vec4<F> finer = sample_levels(texture, fine_level, sampler, uv, live);
  if (none((weight > 0.0f) & live)) return finer;
  const Vec4<F> coarser = sample_levels(texture, min(fine_level + Int(1), Int(last)), sampler, uv, live);
  return mix(finer, coarser, weight);
}

template <Precision P>
void sample_lanes(const Texture& texture, const Sampler& sampler, const float* uv, std::uint32_t live, float* rgba) {
  using F = Float<P>;
  const Vec2<F> coordinates{load<F>(uv), load<F>(uv + kLanes)};
  const Vec4<F> colour = filtered(texture, sampler, coordinates, mask_of(live));
  store(colour.x, rgba);
  store(colour.y, rgba + kLanes);
  store(colour.z, rgba + 2 * kLanes);
  store(colour.w, rgba + 3 * kLanes);
}

template void sample_lanes<Precision::exact>(const Texture&, const Sampler&, const float*, std::uint32_t, float*);
template void sample_lanes<Precision::fast>(const Texture&, const Sampler&, const float*, std::uint32_t, float*);

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();
