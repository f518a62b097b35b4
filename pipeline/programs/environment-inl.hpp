// What lies around, looked up in a map by a direction.                                 [A 1.4] [B 4.1.3]

#if defined(TUBERIA_PIPELINE_PROGRAMS_ENVIRONMENT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_PROGRAMS_ENVIRONMENT_INL
#undef TUBERIA_PIPELINE_PROGRAMS_ENVIRONMENT_INL
#else
#define TUBERIA_PIPELINE_PROGRAMS_ENVIRONMENT_INL
#endif

#include <algorithm>

#include "pipeline/programs/environment_map.hpp"
#include "pipeline/programs/sphere_mapping-inl.hpp"
#include "raster/simd/elementary-inl.hpp"
#include "raster/simd/quad-inl.hpp"
#include "raster/simd/texture-inl.hpp"
#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// The unit direction in the map's axes. What has no direction, a zero or not-a-number, counts as +z.
template <class F>
HWY_INLINE Vec3<F> direction_in_map(const EnvironmentMap& map, Vec3<F> world) {
  const glm::mat3& m = map.map_from_world;
  const Vec3<F> d = normalize(Vec3<F>(m[0]) * world.x + Vec3<F>(m[1]) * world.y + Vec3<F>(m[2]) * world.z);
  const Mask has_direction = dot(d, d) > 0.5f;
  return {select(has_direction, d.x, F(0.0f)), select(has_direction, d.y, F(0.0f)), select(has_direction, d.z, F(1.0f))};
}

/// An equirectangular picture; along its equator a texel spans the same angle both ways if it is 2 to 1.
template <class Fragment, class F>
HWY_INLINE Vec3<F> panorama_radiance(Fragment& in, const EnvironmentMap& map, Vec3<F> unit) {
  constexpr float kTurnsPerRadian = 0.159154943f;
  const F azimuth = atan2(unit.x, -unit.z);
  // An arc tangent again: an arc cosine would lose the digits that tell directions near the poles apart.
  const F polar = atan2(sqrt(unit.x * unit.x + unit.z * unit.z), unit.y);
  const Vec3<F> at(azimuth * kTurnsPerRadian + 0.5f, polar * (2 * kTurnsPerRadian), F(0.0f));
  const TextureLevel& base = map.texture->level(0);
  const auto width = static_cast<float>(base.width), height = static_cast<float>(base.height);
  Sampler sampler = map.sampler;
  sampler.wrap_u = Wrap::repeat;
  sampler.wrap_v = Wrap::clamp;
  const F level = angular_level(unit, kTurnsPerRadian * std::max(width, 2 * height));
  return sample_at_level(*map.texture, sampler, at, level, in.live()).rgb();
}

/// A mirror ball. It maps areas of the sphere of directions to areas of the picture by one factor, which
/// gives the texels per radian: pi (size / 2)^2 for 4 pi.
template <class Fragment, class F>
HWY_INLINE Vec3<F> sphere_map_radiance(Fragment& in, const EnvironmentMap& map, Vec3<F> unit) {
  const Vec3<F> halfway(unit.x, unit.y, unit.z + 1.0f);
  // At -z, which the whole rim shows, the square vanishes: any small number leads to somewhere on the disc.
  const F scale = inverse_sqrt(max(dot(halfway, halfway), 1e-30f)) * 0.5f;
  const Vec3<F> at(unit.x * scale + 0.5f, 0.5f - unit.y * scale, F(0.0f));
  const TextureLevel& base = map.texture->level(0);
  Sampler sampler = map.sampler;
  sampler.wrap_u = sampler.wrap_v = Wrap::clamp;
  const F level = angular_level(unit, 0.25f * static_cast<float>(std::max(base.width, base.height)));
  return sample_at_level(*map.texture, sampler, at, level, in.live()).rgb();
}

/// The radiance that comes from a direction in world space, of any length; black without a map.
template <class Fragment, class F>
HWY_INLINE Vec3<F> environment_radiance(Fragment& in, const EnvironmentMap& map, Vec3<F> direction) {
  if (map.kind == EnvironmentMap::Kind::none) return Vec3<F>(F(0.0f));
  const Vec3<F> unit = direction_in_map(map, direction);
  switch (map.kind) {
    case EnvironmentMap::Kind::panorama: return panorama_radiance(in, map, unit);
    case EnvironmentMap::Kind::sphere: return sphere_map_radiance(in, map, unit);
    case EnvironmentMap::Kind::cube:
    case EnvironmentMap::Kind::none: break;
  }
  return in.sample(*map.texture, map.sampler, unit).rgb();
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
