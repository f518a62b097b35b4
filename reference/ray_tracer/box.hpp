#pragma once
// Boxes along the axes, and spheres, that contain things; in double.

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "reference/ray_tracer/ray.hpp"

namespace tuberia::tracer {

/// lower > upper is the empty box; infinite sides are allowed.
struct Box {
  glm::dvec3 lower{kInfinity}, upper{-kInfinity};

  bool empty() const noexcept { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
  glm::dvec3 size() const noexcept { return upper - lower; }
  glm::dvec3 centre() const noexcept { return 0.5 * lower + 0.5 * upper; }
  void add(const glm::dvec3& point) noexcept {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  void add(const Box& other) noexcept {
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
  }
  /// Half of its surface, to which the chance that a ray meets it is proportional.
  double half_area() const noexcept {
    const glm::dvec3 s = size();
    return s.x * s.y + s.y * s.z + s.z * s.x;
  }
  bool operator==(const Box&) const = default;
};

/// Contains a thing, so that a ray that passes it by need not ask the thing itself.             [B 5.7.1]
struct BoundingSphere {
  glm::dvec3 centre{0};
  double radius = 0;
};

inline BoundingSphere sphere_around(const Box& box) noexcept { return {.centre = box.centre(), .radius = glm::length(box.upper - box.centre())}; }

}  // namespace tuberia::tracer
