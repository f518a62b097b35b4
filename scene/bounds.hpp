#pragma once
// A box along the axes.

#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace tuberia {

/// The smallest box around some points, in their space; without points it is empty, with
/// lower > upper.
struct Bounds {
  glm::vec3 lower{std::numeric_limits<float>::infinity()};
  glm::vec3 upper{-std::numeric_limits<float>::infinity()};

  bool empty() const noexcept { return !(lower.x <= upper.x); }
  /// The middle; the origin if empty.
  glm::vec3 centre() const noexcept { return empty() ? glm::vec3(0) : 0.5f * lower + 0.5f * upper; }
  /// Of the sphere around the box; 0 if empty.
  float radius() const noexcept { return empty() ? 0.0f : glm::length(0.5f * upper - 0.5f * lower); }

  void add(const glm::vec3& point) noexcept {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  void add(const Bounds& other) noexcept {
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
  }
  bool operator==(const Bounds&) const = default;
};

}  // namespace tuberia
