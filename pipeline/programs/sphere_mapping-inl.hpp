// Texture coordinates from the direction in which a point lies, as on a globe.          [B 4-2 to 4-5]

#if defined(TUBERIA_PIPELINE_PROGRAMS_SPHERE_MAPPING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_PROGRAMS_SPHERE_MAPPING_INL
#undef TUBERIA_PIPELINE_PROGRAMS_SPHERE_MAPPING_INL
#else
#define TUBERIA_PIPELINE_PROGRAMS_SPHERE_MAPPING_INL
#endif

#include "raster/simd/elementary-inl.hpp"
#include "raster/simd/quad-inl.hpp"
#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// The level of detail by the angle to the neighbouring fragments' directions, one for each quad. The
/// derivatives of u and v would jump at a map's seam and grow beyond bounds at its poles (and at the rim of a
/// mirror ball), where nothing but the map's coordinates is singular.
template <class F>
HWY_INLINE F angular_level(Vec3<F> unit, float texels_per_radian) {
  const Vec3<F> dx{first_difference_x(unit.x), first_difference_x(unit.y), first_difference_x(unit.z)};
  const Vec3<F> dy{first_difference_y(unit.x), first_difference_y(unit.y), first_difference_y(unit.z)};
  const F squared = first_of_quad(max(dot(dx, dx), dot(dy, dy)));
  return log2(squared * (texels_per_radian * texels_per_radian)) * 0.5f;
}

/// u and v in [0, 1] of a direction of any length, pole +y, u = 0 at +x and growing towards -z, v = 0 at the south
/// pole; (0, 0) of no direction. At the poles u is 0.
/// The notes' arc cosines, mirrored by the sign of (Tp x Te).N, are these angles of directions, which lose no digits
/// where a cosine is near 1.
template <class F>
HWY_INLINE Vec2<F> sphere_coordinates(Vec3<F> direction) {
  const Vec3<F> n = normalize(direction);
  const F turn = atan2(-n.z, n.x) * 0.159154943f;
  // Of tiny negative turns plus 1 the float may be 1: the next meridian's.
  return {select(turn < 0.0f, turn + 1.0f, turn), atan2(sqrt(n.x * n.x + n.z * n.z), -n.y) * 0.318309886f};
}

/// The same with texture rows that run down from the north pole, and u taken on at the seam (beyond 1 or below 0) so that
/// it changes by less than half a turn within a quad: derivatives know of no seam.
template <class F>
HWY_INLINE Vec2<F> sphere_texcoord(Vec3<F> direction) {
  const Vec2<F> uv = sphere_coordinates(direction);
  const F turns_away = floor(uv.x - first_of_quad(uv.x) + 0.5f);
  return {uv.x - turns_away, 1.0f - uv.y};
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
