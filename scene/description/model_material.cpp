#include "scene/description/model_material.hpp"

#include <algorithm>
#include <cmath>

namespace tuberia {
namespace {

constexpr float kDielectricReflectance = 0.04f;  // of a refractive index of 1.5

/// The index whose Fresnel reflectance at normal incidence this is.
float index_of(float reflectance) {
  const float root = std::min(std::sqrt(std::max(reflectance, 0.0f)), 0.98f);
  return (1 + root) / (1 - root);
}

void describe_metallic_roughness(const MetallicRoughness& from, bool reflects_surroundings, description::Material& to) {
  const glm::vec3 base = to.diffuse;
  const glm::vec3 reflectance = glm::vec3(kDielectricReflectance) * (1 - from.metallic) + base * from.metallic;
  to.model = description::Reflection::cook_torrance;
  to.divided_by_pi = false;
  to.ambient = base;
  to.diffuse = base * (1 - from.metallic);
  to.specular = glm::vec3(1);
  to.roughness = std::max(0.02, static_cast<double>(from.roughness * from.roughness));
  to.refractive_index = {index_of(reflectance.r), index_of(reflectance.g), index_of(reflectance.b)};
  if (reflects_surroundings) to.mirror = reflectance * (1 - from.roughness) * (1 - from.roughness);
}

}  // namespace

description::Material description_of(const Material& from, bool reflects_surroundings) {
  description::Material to;
  to.name = from.name;
  to.model = from.shininess > 0 ? description::Reflection::blinn_phong : description::Reflection::lambert;
  to.diffuse = glm::vec3(from.base_colour);
  to.specular = from.specular;
  to.exponent = static_cast<double>(from.shininess);
  to.alpha = static_cast<double>(from.base_colour.a);
  to.two_sided = from.two_sided;
  if (from.metallic_roughness) describe_metallic_roughness(*from.metallic_roughness, reflects_surroundings, to);
  return to;
}

}  // namespace tuberia
