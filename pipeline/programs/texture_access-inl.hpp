// A surface's texture for a register of fragments, at coordinates and levels by the rules of
// texture_access.hpp.

#if defined(TUBERIA_PIPELINE_PROGRAMS_TEXTURE_ACCESS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_PROGRAMS_TEXTURE_ACCESS_INL
#undef TUBERIA_PIPELINE_PROGRAMS_TEXTURE_ACCESS_INL
#else
#define TUBERIA_PIPELINE_PROGRAMS_TEXTURE_ACCESS_INL
#endif

#include "pipeline/programs/sphere_mapping-inl.hpp"
#include "pipeline/programs/texture_access.hpp"
#include "pipeline/programs/transformed-inl.hpp"
#include "raster/sampler.hpp"
#include "raster/simd/elementary-inl.hpp"
#include "raster/simd/texture-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// In place of the vertices' texture coordinates uv those of the globe, if they are asked for.
template <class F>
HWY_INLINE Vec2<F> accessed_texcoord(const TextureAccess& access, Vec2<F> uv, Vec3<F> point) {
  if (access.coordinates == TextureAccess::Coordinates::vertices) return uv;
  return sphere_texcoord(transformed(access.globe_from_world, point));
}

/// The texture's colour. in: samples textures; eye, point: world space.                [A 1.1]
template <class Reader, class F>
HWY_INLINE Vec4<F> accessed_colour(Reader& in, const Texture& texture, const Sampler& sampler, const TextureAccess& access, Vec2<F> uv, Vec3<F> eye, Vec3<F> point) {
  if (access.level_rule == TextureAccess::LevelRule::derivatives) return in.sample(texture, sampler, uv);
  const F level = log2(length(point - eye) * (1.0f / access.texel_distance));
  return sample_at_level(texture, sampler, Vec3<F>(uv.x, uv.y, F(0.0f)), level, in.live());
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
