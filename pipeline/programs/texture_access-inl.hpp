// A surface's texture for a register of fragments, at coordinates and levels by the rules of
// texture_access.hpp.

#if defined(TUBERIA_PIPELINE_PROGRAMS_TEXTURE_ACCESS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_PROGRAMS_TEXTURE_ACCESS_INL
#undef TUBERIA_PIPELINE_PROGRAMS_TEXTURE_ACCESS_INL
#else
#define TUBERIA_PIPELINE_PROGRAMS_TEXTURE_ACCESS_INL
#endif

#include <algorithm>

#include "pipeline/programs/sphere_mapping-inl.hpp"
#include "pipeline/programs/texture_access.hpp"
#include "pipeline/programs/transformed-inl.hpp"
#include "raster/sampler.hpp"
#include "raster/simd/elementary-inl.hpp"
#include "raster/simd/texture_at_level-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// In place of the vertices' texture coordinates uv those of the globe, if they are asked for.
template <class F>
HWY_INLINE Vec2<F> accessed_texcoord(const TextureAccess& access, Vec2<F> uv, Vec3<F> point) {
  if (access.coordinates == TextureAccess::Coordinates::vertices) return uv;
  return sphere_texcoord(transformed(access.globe_from_world, point));
}

/// The level of detail where it is not that of the coordinates' derivatives.
template <class F>
HWY_INLINE F accessed_level(const Texture& texture, const TextureAccess& access, Vec3<F> eye, Vec3<F> point) {
  if (access.level_rule == TextureAccess::LevelRule::distance) return log2(length(point - eye) * (1.0f / access.texel_distance));
  const TextureLevel& base = texture.level(0);
  const float texels_per_turn = static_cast<float>(std::max(base.width, 2 * base.height));
  return angular_level(normalize(transformed(access.globe_from_world, point)), texels_per_turn * 0.159154943f);
}

/// Whether a texture is read at the vertices' coordinates and by their derivatives.
constexpr bool is_usual(const TextureAccess& access) {
  return access.coordinates == TextureAccess::Coordinates::vertices && access.level_rule == TextureAccess::LevelRule::derivatives;
}

/// The texture's colour at uv, which are accessed_texcoord's. in: samples textures; eye, point: world space.   [A 1.1]
template <class Reader, class F>
HWY_INLINE Vec4<F> accessed_colour(Reader& in, const Texture& texture, const Sampler& sampler, const TextureAccess& access, Vec2<F> uv, Vec3<F> eye, Vec3<F> point) {
  if (is_usual(access)) return in.sample(texture, sampler, uv);
  Sampler wrapped = sampler;
  if (access.coordinates == TextureAccess::Coordinates::sphere) wrapped.wrap_u = Wrap::repeat, wrapped.wrap_v = Wrap::clamp;
  return sample_at_level(texture, wrapped, uv, accessed_level(texture, access, eye, point), in.live());
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
