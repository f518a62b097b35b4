// Whether a light reaches a fragment, and what picture it throws there: look-ups in what the light sees.

#if defined(TUBERIA_PIPELINE_PROGRAMS_SHADOW_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_PROGRAMS_SHADOW_INL
#undef TUBERIA_PIPELINE_PROGRAMS_SHADOW_INL
#else
#define TUBERIA_PIPELINE_PROGRAMS_SHADOW_INL
#endif

#include "pipeline/programs/shadow_map.hpp"
#include "raster/simd/cube_face-inl.hpp"
#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// A row of the product with (point, 1).
template <class F>
HWY_INLINE F map_coordinate(const glm::mat4& map_from_world, int row, Vec3<F> point) {
  const glm::mat4& m = map_from_world;
  return mul_add(point.z, F(m[2][row]), mul_add(point.y, F(m[1][row]), mul_add(point.x, F(m[0][row]), F(m[3][row]))));
}

/// A point as a light sees it.
template <class F>
struct MapPoint {
  F s, t, depth;
  Mask inside;  // before the light and within its picture, where nothing that is not a number is
};

template <class F>
HWY_INLINE Mask is_in_picture(F w, F s, F t) {
  return (w > 0.0f) & (s >= 0.0f) & (s <= 1.0f) & (t >= 0.0f) & (t <= 1.0f);
}

template <class F>
HWY_INLINE MapPoint<F> map_point(const glm::mat4& map_from_world, Vec3<F> point) {
  const F w = map_coordinate(map_from_world, 3, point);
  const F scale = 1.0f / w;
  const F s = map_coordinate(map_from_world, 0, point) * scale;
  const F t = map_coordinate(map_from_world, 1, point) * scale;
  const F depth = map_coordinate(map_from_world, 2, point) * scale;
  return {s, t, depth, is_in_picture(w, s, t)};
}

/// A point seen by a light that looks all around: on one of six faces.
template <class F>
struct FacePoint {
  CubeFace face;
  Vec3<F> in_face;  // along the face's s and t, and outwards
};

template <class F>
HWY_INLINE FacePoint<F> face_point(const ShadowMap& map, Vec3<F> point) {
  const glm::mat4& m = map.map_from_world;
  const Vec3<F> seen{map_coordinate(m, 0, point), map_coordinate(m, 1, point), map_coordinate(m, 2, point)};
  const CubeFace face = face_of(seen);
  return {face, in_frame(face, seen, -seen)};
}

template <class F>
HWY_INLINE MapPoint<F> map_point(const ShadowMap& map, const FacePoint<F>& point) {
  const F scale = 1.0f / point.in_face.z;
  const F s = mul_add(point.in_face.x * scale, F(0.5f), F(0.5f)), t = mul_add(point.in_face.y * scale, F(0.5f), F(0.5f));
  return {s, t, mul_add(scale, F(map.cube_depth.y), F(map.cube_depth.x)), is_in_picture(point.in_face.z, s, t)};
}

/// How high over a surface's tangent plane a point must be to clear all depths that it is compared with.
template <class F>
HWY_INLINE F clear_height(const ShadowMap& map, Vec3<F> point, Vec3<F> n) {
  // From the middle of a texel to where its depth is still compared with, in texels; vertices are snapped
  // to 1/256 of them, so depths may belong to a point that is half of that away, and another half is slack.
  const float reach = 0.5f * static_cast<float>(map.taps) + 1.0f / 256;
  if (map.depths->kind() == TextureKind::cube) {
    const FacePoint<F> seen = face_point(map, point);
    const Vec3<F> tilt = in_frame(seen.face, n, -n);
    return (abs(tilt.x) + abs(tilt.y)) * seen.in_face.z * (reach * 2.0f / static_cast<float>(map.depths->level(0).width));
  }
  const F tilt = abs(dot(n, Vec3<F>(map.texel_right))) + abs(dot(n, Vec3<F>(map.texel_down)));
  return tilt * map_coordinate(map.map_from_world, 3, point) * reach;
}

/// The point that is compared in place of a surface's own. n, l: unit, the normal and towards the light.
template <class F>
HWY_INLINE Vec3<F> biased_point(const ShadowMap& map, Vec3<F> point, Vec3<F> n, Vec3<F> l, F light_cosine) {
  const F height = clear_height(map, point, n);
  // Where light grazes, a long way leads up to that height; below this cosine it hardly shows.
  constexpr float kLeastCosine = 1e-3f;
  const F towards_light = height / select(light_cosine > kLeastCosine, light_cosine, F(kLeastCosine));
  return point + l * (towards_light * map.slope_bias + map.constant_bias) + n * (height * map.normal_offset);
}

/// The integral over a box taps - 1 wide, from `fraction` on, of what is value(0) up to 1, value(1) up to
/// 2 and so on; of one value the value. Where all are 1 it is taps - 1, without any rounding.
template <class F, class Value>
HWY_INLINE F box_filtered(int taps, F fraction, const Value& value) {
  const F first = value(0);
  if (taps == 1) return first;
  F sum = mix(first, value(taps - 1), fraction);
  for (int i = 1; i < taps - 1; ++i) sum += value(i);
  return sum;
}

/// How much of the texels around a point lets the light pass to it, 0 to 1: "percentage closer". Of the
/// texels beyond a picture's edge its edge texels take the place.             [Reeves]
template <class F>
HWY_INLINE F lit_share(const ShadowMap& map, const MapPoint<F>& at, Int first_texel) {
  const TextureLevel& level = map.depths->level(0);
  const F reference = at.depth - map.depth_error;
  const float margin = 0.5f * static_cast<float>(map.taps - 1);
  const F x = select(at.inside, at.s, F(0.5f)) * static_cast<float>(level.width) - margin;
  const F y = select(at.inside, at.t, F(0.5f)) * static_cast<float>(level.height) - margin;
  const F left = floor(x), top = floor(y);
  const auto within = [](Int i, int size) HWY_ATTR { return max(min(i, Int(size - 1)), Int(0)); };
  const F sum = box_filtered(map.taps, y - top, [&](int j) HWY_ATTR {
    const Int row = within(truncate_to_int(top) + Int(j), level.height) * Int(level.width) + first_texel;
    return box_filtered(map.taps, x - left, [&](int i) HWY_ATTR {
      const F depth = gather<F>(level.floats, row + within(truncate_to_int(left) + Int(i), level.width));
      // Where nothing was drawn nothing casts shadow, even on what lies beyond the light's far plane.
      return select((reference > depth) & (depth < 1.0f), F(0.0f), F(1.0f));
    });
  });
  // Times the reciprocal is 1 for a sum of box * box, up to kMaxTaps.
  const auto box = static_cast<float>(map.taps > 1 ? map.taps - 1 : 1);
  return sum * (1.0f / (box * box));
}

template <class F>
HWY_NOINLINE F visibility_out_of_line(const ShadowMap& map, const Vec3<F>& point, const Vec3<F>& n, const Vec3<F>& l) {
  const F light_cosine = dot(n, l);
  const Vec3<F> compared = biased_point(map, point, n, l, light_cosine);
  MapPoint<F> at;
  Int first_texel(0);
  if (map.depths->kind() == TextureKind::cube) {
    const FacePoint<F> seen = face_point(map, compared);
    at = map_point(map, seen);
    first_texel = seen.face.number() * Int(map.depths->level(0).width * map.depths->level(0).height);
  } else {
    at = map_point(map.map_from_world, compared);
  }
  const F open_sky = select(light_cosine > 0.0f, F(1.0f), F(0.0f));
  if (none(at.inside)) return open_sky;
  return select(at.inside, lit_share(map, at, first_texel), F(1.0f)) * open_sky;
}

template <class Fragment, class F>
HWY_NOINLINE Vec3<F> projection_out_of_line(const Fragment& in, const ProjectedTexture& projected, const Vec3<F>& point) {
  const MapPoint<F> at = map_point(projected.map_from_world, point);
  if (none(at.inside)) return Vec3<F>(F(0.0f));
  const Vec3<F> colour = in.sample(*projected.texture, projected.sampler, Vec2<F>{at.s, at.t}).rgb();
  const auto thrown = [&](F channel) HWY_ATTR { return select(at.inside, channel, F(0.0f)); };
  return {thrown(colour.x), thrown(colour.y), thrown(colour.z)};
}

// The two that programs call take copies, so that only what has a shadow or a picture puts its numbers in
// memory: where a program's own had their addresses taken, every light without cost a tenth more.

/// V: how much of a light reaches a point, 0 to 1; none where the surface is turned away. n, l: unit, the
/// surface's normal (without relief) and the direction to the light. Outside of the light's view V is 1.
///                                                                                    [A 1.3] [FIX 13]
template <class F>
HWY_INLINE F light_visibility(const ShadowMap& map, Vec3<F> point, Vec3<F> n, Vec3<F> l) {
  return visibility_out_of_line(map, point, n, l);
}

/// The colour that a projector throws on a point; the texture's level follows from how much its coordinates
/// change from fragment to fragment.
template <class Fragment, class F>
HWY_INLINE Vec3<F> projected_light(const Fragment& in, const ProjectedTexture& projected, Vec3<F> point) {
  return projection_out_of_line(in, projected, point);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
