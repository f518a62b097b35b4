// One mipmap level of any texture but a cube map, in any format: rows, rectangles and boxes of texels.

#if defined(TUBERIA_RASTER_SIMD_TEXTURE_GRID_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_TEXTURE_GRID_INL
#undef TUBERIA_RASTER_SIMD_TEXTURE_GRID_INL
#else
#define TUBERIA_RASTER_SIMD_TEXTURE_GRID_INL
#endif

#include "raster/simd/texel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Where a texture is read, and what its depths are compared with.
template <class F>
struct Place {
  Vec3<F> at;
  F reference;
};

/// 1 where the reference stands in this relation to the texel, 0 elsewhere.
template <class F>
HWY_INLINE F truth_of(Compare compare, F reference, F texel) {
  const auto truth = [&](Mask m) HWY_ATTR { return select(m, F(1.0f), F(0.0f)); };
  switch (compare) {
    case Compare::never: return F(0.0f);
    case Compare::less: return truth(reference < texel);
    case Compare::equal: return truth(reference == texel);
    case Compare::less_equal: return truth(reference <= texel);
    case Compare::greater: return truth(reference > texel);
    case Compare::not_equal: return truth(!(reference == texel));
    case Compare::greater_equal: return truth(reference >= texel);
    case Compare::always: break;
  }
  return F(1.0f);
}

/// A texel as it is filtered: see `channels`; floats as they are; depths as (d, d, d, 1) or compared.
template <class F>
HWY_INLINE Vec4<F> border_texel(const Texture& texture, const Rgba32F& border) {
  if (texture.format() == TextureFormat::depth32f) return {F(border.r), F(border.r), F(border.r), F(1.0f)};
  if (texture.format() == TextureFormat::rgba32f) return {F(border.r), F(border.g), F(border.b), F(border.a)};
  const float colour_scale = texture.encoding() == TextureEncoding::srgb ? 1.0f : 255.0f;
  return {F(border.r * colour_scale), F(border.g * colour_scale), F(border.b * colour_scale), F(border.a * 255.0f)};
}

template <class F>
HWY_INLINE Vec4<F> stored_texel(const Texture& texture, const TextureLevel& level, Int index) {
  switch (texture.format()) {
    case TextureFormat::rgba8: break;
    case TextureFormat::rgba32f: {
      const Int first = shift_left<2>(index);
      return {gather<F>(level.floats, first), gather<F>(level.floats + 1, first), gather<F>(level.floats + 2, first),
              gather<F>(level.floats + 3, first)};
    }
    case TextureFormat::depth32f: {
      const F depth = gather<F>(level.floats, index);
      return {depth, depth, depth, F(1.0f)};
    }
  }
  return channels<F>(gather(reinterpret_cast<const std::int32_t*>(level.texels), index), texture.encoding());
}

/// The texels at these indices, or the border where `outside`, compared if they are to be.
template <class F>
HWY_NOINLINE Vec4<F> texel(const Texture& texture, const TextureLevel& level, const Sampler& sampler, const Int& index,
                           const Mask& outside, const F& reference) {
  Vec4<F> t = stored_texel<F>(texture, level, index);
  if (any(outside)) {
    const Vec4<F> border = border_texel<F>(texture, sampler.border);
    t = {select(outside, border.x, t.x), select(outside, border.y, t.y), select(outside, border.z, t.z), select(outside, border.w, t.w)};
  }
  if (texture.format() != TextureFormat::depth32f || !sampler.compare) return t;
  const F truth = truth_of(*sampler.compare, reference, t.x);
  return {truth, truth, truth, F(1.0f)};
}

/// Filtered texels to intensities.
template <class F>
HWY_INLINE Vec4<F> finished(const Texture& texture, const Vec4<F>& filtered) {
  return texture.format() == TextureFormat::rgba8 ? intensities(filtered, texture.encoding()) : filtered;
}

/// The two texels of a row that a coordinate lies between (one twice, when not filtered), in bounds.
template <class F>
struct Axis {
  Int near = Int(0), far = Int(0);
  Mask near_outside, far_outside;  // the border is there instead
  F weight = F(0.0f);              // of the far one

  HWY_INLINE Axis() : near_outside(mask_of(0)), far_outside(mask_of(0)) {}
  HWY_INLINE Axis(F coordinate, int size, Wrap wrap, const Sampler& sampler) : Axis() {
    const F x = reduce_coordinate(coordinate, wrap) * static_cast<float>(size);
    const F shifted = sampler.texels == TexelFilter::nearest ? x : x - 0.5f;
    const F first = floor(shifted);
    if (sampler.texels == TexelFilter::bilinear) weight = filter_weight(shifted - first, sampler);
    place(truncate_to_int(first), size, wrap, near, near_outside);
    place(truncate_to_int(first) + Int(1), size, wrap, far, far_outside);
  }

 private:
  static HWY_INLINE void place(Int i, int size, Wrap wrap, Int& index, Mask& outside) {
    const Int wrapped = wrap_index(i, size, wrap), last(size - 1);
    if (wrap == Wrap::border) outside = (wrapped < Int(0)) | (wrapped > last);
    index = max(min(wrapped, last), Int(0));
  }
};

/// Any grid of texels as a box; axes that a texture lacks have one texel.
template <class F>
HWY_NOINLINE Vec4<F> sample_grid(const Texture& texture, const TextureLevel& level, const Sampler& sampler, const Place<F>& place) {
  const bool has_rows = texture.kind() != TextureKind::one_dimensional;
  const bool has_slices = texture.kind() == TextureKind::three_dimensional;
  const Axis<F> x(place.at.x, level.width, sampler.wrap_u, sampler);
  const Axis<F> y = has_rows ? Axis<F>(place.at.y, level.height, sampler.wrap_v, sampler) : Axis<F>();
  const Axis<F> z = has_slices ? Axis<F>(place.at.z, level.slices, sampler.wrap_w, sampler) : Axis<F>();

  const bool nearest = sampler.texels == TexelFilter::nearest;
  const auto line = [&](Int row, Mask row_outside) HWY_ATTR {
    const Int first = row * Int(level.width);
    const Vec4<F> near = texel(texture, level, sampler, first + x.near, row_outside | x.near_outside, place.reference);
    if (nearest) return near;
    return mix(near, texel(texture, level, sampler, first + x.far, row_outside | x.far_outside, place.reference), x.weight);
  };
  const auto slice = [&](Int number, Mask slice_outside) HWY_ATTR {
    const Int first = number * Int(level.height);
    const Vec4<F> near = line(first + y.near, slice_outside | y.near_outside);
    if (nearest || !has_rows) return near;
    return mix(near, line(first + y.far, slice_outside | y.far_outside), y.weight);
  };
  const Vec4<F> near = slice(z.near, z.near_outside);
  if (nearest || !has_slices) return finished(texture, near);
  return finished(texture, mix(near, slice(z.far, z.far_outside), z.weight));
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
