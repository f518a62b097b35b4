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

/// u and v in [0, 1] of a direction of any length, pole +y, u = 0 at +x and growing towards -z, v = 0 at the south
/// pole. At the poles, and of no direction, u is 0; v is then 1/2 for no direction.
/// The notes' arc cosine of (Te.N)/sin(phi), mirrored by the sign of (Tp x Te).N, is this angle of a direction, which loses
/// no digits where the cosine is near 1.
template <class F>
HWY_INLINE Vec2<F> sphere_coordinates(Vec3<F> direction) {
  const Vec3<F> n = normalize(direction);
  const F turn = atan2(-n.z, n.x) * 0.159154943f;
  // Of tiny negative turns plus 1 the float may be 1: the next meridian's.
  return {select(turn < 0.0f, turn + 1.0f, turn), acos(-n.y) * 0.318309886f};
}

/// The same with texture rows that run down from the north pole, and u taken on at the seam (beyond 1 or below 0) so that
/// it changes by less than half a turn within a quad: derivatives know of no seam. For textures that repeat along u.
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
