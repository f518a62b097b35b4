#pragma once
// How images lie on plane faces: as on the sides of a box.

#include <cmath>
#include <glm/vec3.hpp>

namespace tuberia::tracer {

/// The number of the coordinate in which a vector is longest; of equal ones the first.
inline int dominant_axis(const glm::dvec3& vector) noexcept {
  const double x = std::abs(vector.x), y = std::abs(vector.y), z = std::abs(vector.z);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

/// The image's directions on the side of a box that looks along `axis`, upright on the sides; seen from above the upper edge is at -z,
/// from below at +z. Unit axes.
struct SideFrame {
  int axis;
  glm::dvec3 right, down;
};

inline SideFrame side_frame(const glm::dvec3& normal) noexcept {
  const int axis = dominant_axis(normal);
  const double sign = normal[axis] < 0 ? -1 : 1;
  if (axis == 0) return {axis, {0, 0, -sign}, {0, -1, 0}};
  if (axis == 1) return {axis, {1, 0, 0}, {0, 0, sign}};
  return {axis, {sign, 0, 0}, {0, -1, 0}};
}

/// The direction in a plane through the origin that looks like `direction` if one looks along the axis.
inline glm::dvec3 dropped_on_plane(const glm::dvec3& direction, const glm::dvec3& normal, int axis) noexcept {
  glm::dvec3 dropped = direction;
  dropped[axis] -= (normal.x * direction.x + normal.y * direction.y + normal.z * direction.z) / normal[axis];
  return dropped;
}

}  // namespace tuberia::tracer
