// Texture sampling where it matters most, rectangles of 8-bit codes: coordinates to texels, filtering
// inside and between mipmap levels. All the rest is in texture_kinds_kernels.cpp.

#include "raster/texture.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "raster/simd/texture_kernels.cpp"
#include "raster/simd/every_instruction_set.hpp"

#include "raster/simd/texel-inl.hpp"
#include "raster/simd/texture-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

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
  if (sampler.mipmaps == MipmapFilter::none || texture.level_count() == 1) return sample_level(texture, 0, sampler, uv);
  return mix_levels(texture, sampler, level_of_detail(texture, uv), live,
                    [&](int level) HWY_ATTR { return sample_level(texture, level, sampler, uv); });
}

template <Precision P>
void sample_lanes(const Texture& texture, const Sampler& sampler, const float* uv, std::uint32_t live, float* rgba) {
  using F = Float<P>;
  const Vec2<F> coordinates{load<F>(uv), load<F>(uv + kLanes)};
  const Vec4<F> colour = is_everyday(texture, sampler)
                             ? filtered(texture, sampler, coordinates, mask_of(live))
                             : sample(texture, sampler, {coordinates.x, coordinates.y, F(0.0f)}, F(0.0f), mask_of(live));
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
