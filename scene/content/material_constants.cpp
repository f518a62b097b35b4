#include "scene/content/material_constants.hpp"

#include <array>
#include <glm/matrix.hpp>

#include "scene/content/placement.hpp"

namespace tuberia {

ReflectionConstants constants_of(const description::Material& material) {
  return {.model = static_cast<Reflection>(material.model),
          .ambient = material.ambient.value_or(material.diffuse),
          .diffuse = material.diffuse,
          .specular = material.model == description::Reflection::lambert ? glm::vec3(0) : material.specular,
          .exponent = static_cast<float>(material.exponent),
          .roughness = static_cast<float>(material.roughness),
          .refractive_index = material.refractive_index,
          .facets = static_cast<FacetDistribution>(material.facets),
          .divided_by_pi = material.divided_by_pi};
}

Pattern pattern_of(const description::Pattern& from) {
  constexpr std::array kKinds{Pattern::Kind::checker, Pattern::Kind::random_squares, Pattern::Kind::wood, Pattern::Kind::marble};
  return {.kind = kKinds[static_cast<std::size_t>(from.kind)], .first = from.first, .second = from.second,
          .scale = static_cast<float>(from.scale), .turbulence = static_cast<float>(from.turbulence), .seed = from.seed,
          .pattern_from_world = glm::inverse(float_matrix_of(from.placement))};
}

}  // namespace tuberia
