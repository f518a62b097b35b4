#include "pipeline/programs/surface_refusal.hpp"

#include <cmath>
#include <initializer_list>
#include <utility>

#include "pipeline/programs/surface_colour_refusal.hpp"
#include "pipeline/refusal.hpp"

namespace tuberia {
namespace {

Refusal check_all_finite(std::initializer_list<std::pair<const char*, glm::vec3>> fields) {
  for (const auto& [field, value] : fields)
    if (Refusal refusal = check_finite(field, value)) return refusal;
  return {};
}

template <class Enumeration>
Refusal check_enumeration(const std::string& field, Enumeration value, Enumeration last) {
  if (value <= last) return {};
  return Error{field + " is " + std::to_string(static_cast<int>(value)) + "; its enumeration ends with " + std::to_string(static_cast<int>(last))};
}

Refusal check_reflection(const ReflectionConstants& r) {
  if (Refusal refusal = check_enumeration("reflection.model", r.model, Reflection::cook_torrance)) return refusal;
  if (Refusal refusal = check_enumeration("reflection.facets", r.facets, FacetDistribution::gaussian)) return refusal;
  if (Refusal refusal = check_all_finite({{"reflection.ambient", r.ambient}, {"reflection.diffuse", r.diffuse}, {"reflection.specular", r.specular}}))
    return refusal;
  if (!(r.exponent >= 0) || !std::isfinite(r.exponent))
    return Error{"reflection.exponent is " + words_of(r.exponent) + "; it must be finite and not negative"};
  if (Refusal refusal = check_range("reflection.roughness", r.roughness, 1e-3f, 1e3f)) return refusal;
  for (int i = 0; i < 3; ++i)
    if (Refusal refusal = check_range(std::string("reflection.refractive_index.") + "xyz"[i], r.refractive_index[i], 1e-3f, 1e3f)) return refusal;
  return {};
}

/// A texture that is of the kind that is looked up, with a sampler that makes sense.
Refusal check_texture(const std::string& field, const std::shared_ptr<const Texture>& texture, const Sampler& sampler, TextureKind kind) {
  if (!texture) return Error{field + " has no texture"};
  if (texture->kind() != kind)
    return Error{field + ".texture " + (kind == TextureKind::cube ? "is no cube map" : "is not a two-dimensional texture")};
  if (const char* refusal = refusal_of(sampler)) return Error{field + ": " + refusal};
  return {};
}

Refusal check_light(const SurfaceLight& light) {
  if (Refusal refusal = refusal_of(light.light)) return refusal;
  if (light.shadow)
    if (const Refusal refusal = refusal_of(*light.shadow)) return Error{"shadow." + refusal->message};
  if (light.projected)
    if (const Refusal refusal = refusal_of(*light.projected)) return Error{"projected." + refusal->message};
  return {};
}

}  // namespace

Refusal refusal_of(const SurfaceUniforms& uniforms) {
  if (Refusal refusal = check_reflection(uniforms.reflection)) return refusal;
  if (Refusal refusal = check_all_finite({{"mirror", uniforms.mirror}, {"ambient_light", uniforms.ambient_light}, {"eye", uniforms.eye}})) return refusal;
  if (Refusal refusal = check_finite("alpha", uniforms.alpha)) return refusal;
  if (Refusal refusal = check_enumeration("normals", uniforms.normals, NormalInterpolation::not_renormalized)) return refusal;
  if (Refusal refusal = check_enumeration("overflow", uniforms.overflow, Overflow::hue_preserving)) return refusal;
  const SurfaceColour& colour = uniforms.colour;
  if (colour.texture)
    if (Refusal refusal = check_texture("colour", colour.texture, colour.sampler, TextureKind::two_dimensional)) return refusal;
  if (Refusal refusal = refusal_of(colour.pattern)) return refusal;
  if (Refusal refusal = refusal_of(colour.access)) return refusal;
  if (Refusal refusal = refusal_of(uniforms.bump)) return refusal;
  if (const Refusal refusal = refusal_of(uniforms.environment)) return Error{"environment: " + refusal->message};
  for (std::size_t i = 0; i < uniforms.lights.size(); ++i)
    if (const Refusal refusal = check_light(uniforms.lights[i])) return Error{"lights[" + std::to_string(i) + "]." + refusal->message};
  return {};
}

}  // namespace tuberia
