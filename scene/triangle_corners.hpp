#pragma once
// The corners of a mesh's triangles. Corner 3 i + k is corner k of triangle i.

#include <cmath>
#include <cstdint>
#include <glm/ext/vector_double3.hpp>
#include <glm/geometric.hpp>

#include "scene/mesh.hpp"

namespace tuberia {

constexpr std::uint32_t next_corner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
constexpr std::uint32_t previous_corner(std::uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

inline glm::dvec3 position_at(const Mesh& mesh, std::uint32_t corner) { return mesh.positions[mesh.indices[corner]]; }

/// The direction of a vector, or another if it has none.
inline glm::dvec3 unit_or(const glm::dvec3& vector, const glm::dvec3& otherwise) {
  const double length = glm::length(vector);
  return length > 0 && std::isfinite(length) ? vector / length : otherwise;
}

/// On the side from which the triangle is counter-clockwise; 0 if it has no area.
inline glm::dvec3 unit_normal(const Mesh& mesh, std::uint32_t triangle) {
  const glm::dvec3 a = position_at(mesh, 3 * triangle);
  return unit_or(glm::cross(position_at(mesh, 3 * triangle + 1) - a, position_at(mesh, 3 * triangle + 2) - a), glm::dvec3(0));
}

/// Between the two sides at a corner, radians; 0 if a side has no length.
inline double angle_at(const Mesh& mesh, std::uint32_t corner) {
  const glm::dvec3 here = position_at(mesh, corner);
  const glm::dvec3 a = position_at(mesh, next_corner(corner)) - here, b = position_at(mesh, previous_corner(corner)) - here;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace tuberia
