#include "math/reflection.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/assertion.hpp"
#include "math/optics.hpp"

namespace tuberia {
namespace {

[[maybe_unused]] bool is_unit(const glm::dvec3& v) { return std::abs(glm::dot(v, v) - 1) < 1e-6; }

/// N.L of vectors that are what their names promise.
double cosine_of_light(const LitPoint& at) {
  TUBERIA_ASSERT(is_unit(at.normal), "the normal is not unit");
  TUBERIA_ASSERT(is_unit(at.to_light), "the direction to the light is not unit");
  TUBERIA_ASSERT(is_unit(at.to_eye), "the direction to the eye is not unit");
  return glm::dot(at.normal, at.to_light);
}

glm::dvec3 halfway(const LitPoint& at) { return normalized_or(at.to_light + at.to_eye, glm::dvec3(0)); }

double power_of_cosine(double cosine, double exponent) { return std::pow(std::max(cosine, 0.0), exponent); }

glm::dvec3 specular_share(const ReflectionConstants& c, const LitPoint& at) {
  const double n = static_cast<double>(c.exponent);
  switch (c.model) {
    case Reflection::lambert: return glm::dvec3(0);
    case Reflection::phong: return glm::dvec3(phong_share(at, n));
    case Reflection::blinn_phong: return glm::dvec3(blinn_phong_share(at, n));
    case Reflection::weighted_phong:
    case Reflection::cook_torrance: break;
  }
  glm::dvec3 share;
  for (int i = 0; i < 3; ++i) {
    const double index = static_cast<double>(c.refractive_index[i]);
    share[i] = c.model == Reflection::weighted_phong ? weighted_phong_share(at, n, index) : cook_torrance_share(at, c, index);
  }
  return share;
}

}  // namespace

double diffuse_share(const LitPoint& at) noexcept { return std::max(cosine_of_light(at), 0.0); }

double phong_share(const LitPoint& at, double exponent) noexcept {
  if (cosine_of_light(at) <= 0) return 0;
  return power_of_cosine(glm::dot(-reflected(at.to_light, at.normal), at.to_eye), exponent);
}

double blinn_phong_share(const LitPoint& at, double exponent) noexcept {
  if (cosine_of_light(at) <= 0) return 0;
  return power_of_cosine(glm::dot(at.normal, halfway(at)), exponent);
}

double weighted_phong_share(const LitPoint& at, double exponent, double refractive_index) noexcept {
  return fresnel_share(diffuse_share(at), refractive_index) * phong_share(at, exponent);
}

double cook_torrance_share(const LitPoint& at, const ReflectionConstants& constants, double refractive_index) noexcept {
  const double cos_eye = glm::dot(at.normal, at.to_eye);
  if (cosine_of_light(at) <= 0 || cos_eye <= 0) return 0;
  const glm::dvec3 h = halfway(at);
  const double d = facet_density(constants.facets, glm::dot(at.normal, h), static_cast<double>(constants.roughness));
  const double f = fresnel_share(std::clamp(glm::dot(at.to_eye, h), 0.0, 1.0), refractive_index);
  return d * shadowing_and_masking(at) * f / ((constants.divided_by_pi ? std::numbers::pi : 4) * cos_eye);
}

glm::dvec3 reflected_share(const ReflectionConstants& constants, const LitPoint& at) noexcept {
  return glm::dvec3(constants.diffuse) * diffuse_share(at) + glm::dvec3(constants.specular) * specular_share(constants, at);
}

double shadowing_and_masking(const LitPoint& at) noexcept {
  const glm::dvec3 h = halfway(at);
  const double cos_facet = glm::dot(at.normal, h), cos_light = glm::dot(at.normal, at.to_light), cos_eye = glm::dot(at.normal, at.to_eye);
  const double lesser = std::min(cos_light, cos_eye);
  if (lesser <= 0 || cos_facet <= 0) return 0;
  return std::min(1.0, 2 * cos_facet * lesser / glm::dot(at.to_eye, h));
}

double facet_density(FacetDistribution distribution, double cos_angle, double roughness) noexcept {
  if (distribution == FacetDistribution::beckmann) return std::numbers::pi * beckmann(cos_angle, roughness);
  if (!(cos_angle > 0)) return 0;
  const double ratio = std::acos(std::min(cos_angle, 1.0)) / roughness;
  return std::exp(-ratio * ratio) / (roughness * roughness);
}

double fresnel_share(double cos_incidence, double refractive_index) noexcept {
  const double c = cos_incidence, g_squared = refractive_index * refractive_index + c * c - 1;
  if (g_squared < 0) return 1;  // beyond the critical angle
  const double g = std::sqrt(g_squared);
  if (g + c == 0) return 0;  // along a surface between equals
  const double across = (g - c) / (g + c), within = (c * (g + c) - 1) / (c * (g - c) + 1);
  return 0.5 * across * across * (1 + within * within);
}

double linear_falloff(double distance, double d0) noexcept { return 1 / (distance + d0); }

double inverse_square_falloff(double distance) noexcept { return 1 / (4 * std::numbers::pi * distance * distance); }

}  // namespace tuberia
