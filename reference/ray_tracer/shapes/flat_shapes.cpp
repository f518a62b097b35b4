#include "reference/ray_tracer/shapes/flat_shapes.hpp"

#include <algorithm>

#include "reference/ray_tracer/shapes/crossing.hpp"

namespace tuberia::tracer {
namespace {

/// Where the ray meets the plane y = 0; a ray along the plane does not.        [5-13]
std::optional<double> meet_ground(const Ray& ray) noexcept {
  const double t = -ray.origin.y / ray.direction.y;
  if (ray.direction.y == 0 || !is_within(ray, t)) return std::nullopt;
  return t;
}

glm::dvec3 on_ground(const Ray& ray, double t) noexcept {
  const glm::dvec3 point = ray.at(t);
  return {point.x, 0, point.z};
}

double magnitude_of(const glm::dvec3& point) noexcept { return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}); }

}  // namespace

std::optional<ShapeHit> InfinitePlane::intersect(const Ray& ray) const noexcept {
  const std::optional<double> t = meet_ground(ray);
  if (!t) return std::nullopt;
  return ShapeHit{.t = *t};
}

SurfacePoint InfinitePlane::surface(const Ray& ray, const ShapeHit& hit) const noexcept {
  const glm::dvec3 at = on_ground(ray, hit.t);
  const glm::dvec3 up(0, 1, 0);
  return {.position = at, .geometric_normal = up, .normal = up, .tangent = {1, 0, 0}, .bitangent = {0, 0, 1},
          .texcoord = {at.x, at.z}, .magnitude = magnitude_of(at)};
}

std::optional<ShapeHit> Rectangle::intersect(const Ray& ray) const noexcept {
  const std::optional<double> t = meet_ground(ray);
  if (!t) return std::nullopt;
  const glm::dvec3 at = on_ground(ray, *t);
  const bool has_area = half_.x > 0 && half_.z > 0;
  if (!has_area || !(std::abs(at.x) <= half_.x && std::abs(at.z) <= half_.z)) return std::nullopt;
  return ShapeHit{.t = *t};
}

SurfacePoint Rectangle::surface(const Ray& ray, const ShapeHit& hit) const noexcept {
  const glm::dvec3 at = glm::clamp(on_ground(ray, hit.t), -half_, half_);
  const glm::dvec3 up(0, 1, 0);
  return {.position = at, .geometric_normal = up, .normal = up, .tangent = {2 * half_.x, 0, 0}, .bitangent = {0, 0, 2 * half_.z},
          .texcoord = {0.5 + 0.5 * at.x / half_.x, 0.5 + 0.5 * at.z / half_.z}, .magnitude = magnitude_of(at)};
}

std::optional<ShapeHit> Disc::intersect(const Ray& ray) const noexcept {
  const std::optional<double> t = meet_ground(ray);
  if (!t || !(radius_ > 0)) return std::nullopt;
  const glm::dvec3 at = on_ground(ray, *t);
  if (!(at.x * at.x + at.z * at.z <= radius_ * radius_)) return std::nullopt;
  return ShapeHit{.t = *t};
}

SurfacePoint Disc::surface(const Ray& ray, const ShapeHit& hit) const noexcept { return disc_surface(ray.at(hit.t), radius_, 0, true); }

SurfacePoint disc_surface(const glm::dvec3& point, double radius, double height, bool upwards) noexcept {
  const double side = upwards ? 1 : -1;
  const glm::dvec3 at(point.x, height, point.z), normal(0, side, 0);
  return {.position = at, .geometric_normal = normal, .normal = normal, .tangent = {2 * radius, 0, 0}, .bitangent = {0, 0, side * 2 * radius},
          .texcoord = {0.5 + 0.5 * at.x / radius, 0.5 + 0.5 * side * at.z / radius}, .magnitude = magnitude_of(at)};
}

}  // namespace tuberia::tracer
