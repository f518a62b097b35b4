#include "math/optics.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace tuberia {

glm::dvec3 normalized_or(const glm::dvec3& vector, const glm::dvec3& fallback) noexcept {
  // Divided by a power of two near its largest coordinate first, no square is lost.
  const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
  const bool is_finite = std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
  if (!is_finite || largest == 0) return fallback;
  const int exponent = std::ilogb(largest);
  const glm::dvec3 scaled{std::ldexp(vector.x, -exponent), std::ldexp(vector.y, -exponent), std::ldexp(vector.z, -exponent)};
  return scaled / glm::length(scaled);
}

glm::dvec3 reflected(const glm::dvec3& incident, const glm::dvec3& normal) noexcept {
  const glm::dvec3 unit = normalized_or(normal, glm::dvec3(0));
  return incident - 2 * glm::dot(unit, incident) * unit;
}

std::optional<glm::dvec3> refracted(const glm::dvec3& incident, const glm::dvec3& normal, double n_from, double n_into) noexcept {
  const double ratio = n_from / n_into, cos_in = -glm::dot(normal, incident);
  const double sin_out_squared = ratio * ratio * (1 - cos_in * cos_in);
  if (sin_out_squared > 1) return {};
  return ratio * incident + (ratio * cos_in - std::sqrt(1 - sin_out_squared)) * normal;
}

Reflectance fresnel(double cos_incidence, double n_from, double n_into) noexcept {
  const double ratio = n_from / n_into, sin_out_squared = ratio * ratio * (1 - cos_incidence * cos_incidence);
  if (sin_out_squared >= 1) return {1, 1};
  const double cos_out = std::sqrt(1 - sin_out_squared);
  const double across = (n_from * cos_incidence - n_into * cos_out) / (n_from * cos_incidence + n_into * cos_out);
  const double within = (n_into * cos_incidence - n_from * cos_out) / (n_into * cos_incidence + n_from * cos_out);
  return {across * across, within * within};
}

double beckmann(double cos_angle, double roughness) noexcept {
  if (!(cos_angle > 0)) return 0;
  const double cos_squared = cos_angle * cos_angle, slope_squared = (1 - cos_squared) / cos_squared;
  const double share = std::exp(-slope_squared / (roughness * roughness));
  // Next to the horizon the denominator vanishes, too; the exponential does so long before.
  return share > 0 ? share / (std::numbers::pi * roughness * roughness * cos_squared * cos_squared) : 0;
}

}  // namespace tuberia
