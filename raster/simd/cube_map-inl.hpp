// One mipmap level of a cube map, without seams: texels beyond a face's edge are its neighbour's.

#if defined(TUBERIA_RASTER_SIMD_CUBE_MAP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_CUBE_MAP_INL
#undef TUBERIA_RASTER_SIMD_CUBE_MAP_INL
#else
#define TUBERIA_RASTER_SIMD_CUBE_MAP_INL
#endif

#include "raster/simd/cube_face-inl.hpp"
#include "raster/simd/texture_grid-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

HWY_INLINE Int negated(Int a) { return Int(0) - a; }
HWY_INLINE Int magnitude(Int a) { return max(a, negated(a)); }

/// The way back: from a face's frame to the cube's.
HWY_INLINE Vec3<Int> from_frame(const CubeFace& face, Int s, Int t, Int out) {
  const Int side = select(face.negative, negated(out), out);
  const Int s_back = select(face.negative, negated(s), s);
  return {select(face.on_x, side, select(face.on_y, s, s_back)),
          select(face.on_y, side, negated(t)),
          select(face.on_x, negated(s_back), select(face.on_y, select(face.negative, negated(t), t), side))};
}

/// The index of texel (x, y) of a face of size n, where one of x and y may be -1 or n: then it is the
/// neighbouring face's texel. Where both are (no face has that texel), some texel in bounds.
/// Computed on a cube whose faces lie 2n apart, so that texel centres are whole numbers.
HWY_NOINLINE Int cube_texel_index(const CubeFace& face, const Int& x, const Int& y, int size) {
  const Int n(size), inside(size - 1);
  const Int s = x + x - inside, t = y + y - inside;
  const Mask s_beyond = magnitude(s) > n, t_beyond = (magnitude(t) > n) & !s_beyond;
  const auto towards = [&](Int a, Int distance) HWY_ATTR { return select(is_negative(a), negated(distance), distance); };
  // The texel beyond lies on the neighbour's border: the edge's two directions change their roles.
  const Int folded_s = select(s_beyond, towards(s, n), s);
  const Int folded_t = select(t_beyond, towards(t, n), select(magnitude(t) > n, towards(t, inside), t));
  const Int folded_out = select(s_beyond | t_beyond, inside, n);

  const Vec3<Int> p = from_frame(face, folded_s, folded_t, folded_out);
  const Mask on_x = magnitude(p.x) == n, on_y = magnitude(p.y) == n;
  const CubeFace there{on_x, on_y, is_negative(select(on_x, p.x, select(on_y, p.y, p.z)))};
  const Vec3<Int> q = in_frame(there, p, Vec3<Int>(negated(p.x), negated(p.y), negated(p.z)));
  const Int column = shift_right<1>(q.x + inside), row = shift_right<1>(q.y + inside);
  return (there.number() * n + row) * n + column;
}

/// The mean of three, which is exact when they are equal.
template <class F>
HWY_INLINE Vec4<F> mean_of_three(const Vec4<F>& a, const Vec4<F>& b, const Vec4<F>& c) {
  return a + ((b - a) + (c - a)) * F(1.0f / 3.0f);
}

template <class F>
HWY_INLINE Vec4<F> select(Mask m, const Vec4<F>& yes, const Vec4<F>& no) {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z), select(m, yes.w, no.w)};
}

/// The four texels around a point of a face, at columns x, x+1 and rows y, y+1. At a corner of the
/// cube only three meet; the fourth is their mean.                                    [rules T5]
template <class F>
HWY_NOINLINE Vec4<F> filter_face(const Texture& texture, const TextureLevel& level, const Sampler& sampler, const CubeFace& face,
                                 const Vec2<F>& point, const F& reference) {
  const F left = floor(point.x - 0.5f), top = floor(point.y - 0.5f);
  const F weight_x = filter_weight((point.x - 0.5f) - left, sampler), weight_y = filter_weight((point.y - 0.5f) - top, sampler);
  const Int x0 = truncate_to_int(left), y0 = truncate_to_int(top), x1 = x0 + Int(1), y1 = y0 + Int(1), n(level.width);
  const Mask none_outside = mask_of(0);
  const auto at = [&](Int x, Int y) HWY_ATTR {
    return texel(texture, level, sampler, cube_texel_index(face, x, y, level.width), none_outside, reference);
  };
  Vec4<F> a = at(x0, y0), b = at(x1, y0), c = at(x0, y1), d = at(x1, y1);

  const Mask low_x = is_negative(x0), high_x = x1 == n, low_y = is_negative(y0), high_y = y1 == n;
  if (any((low_x | high_x) & (low_y | high_y))) {
    const Vec4<F> for_a = mean_of_three(b, c, d), for_b = mean_of_three(a, c, d), for_c = mean_of_three(a, b, d), for_d = mean_of_three(a, b, c);
    // (A face of one texel may have two such corners, but never at once: 0 <= x0 or x1 < n.)
    a = select(low_x & low_y, for_a, a);
    b = select(high_x & low_y, for_b, b);
    c = select(low_x & high_y, for_c, c);
    d = select(high_x & high_y, for_d, d);
  }
  return mix(mix(a, b, weight_x), mix(c, d, weight_x), weight_y);
}

template <class F>
HWY_NOINLINE Vec4<F> sample_cube(const Texture& texture, const TextureLevel& level, const Sampler& sampler, const Place<F>& place) {
  const CubeFace face = face_of(place.at);
  const Vec3<F> frame = in_frame(face, place.at, -place.at);
  const float size = static_cast<float>(level.width);
  const Vec2<F> point{saturate((frame.x / frame.z + 1.0f) * 0.5f) * size, saturate((frame.y / frame.z + 1.0f) * 0.5f) * size};
  if (sampler.texels == TexelFilter::bilinear) return finished(texture, filter_face(texture, level, sampler, face, point, place.reference));
  const Int last(level.width - 1);
  const Int column = min(truncate_to_int(floor(point.x)), last), row = min(truncate_to_int(floor(point.y)), last);
  const Int index = (face.number() * Int(level.width) + row) * Int(level.width) + column;
  return finished(texture, texel(texture, level, sampler, index, mask_of(0), place.reference));
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
