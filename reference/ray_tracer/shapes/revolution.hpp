#pragma once
// What surfaces of revolution about the y axis share: u runs counter-clockwise seen from above, from 0 at +x over 1/4 at -z.

#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>

namespace tuberia::tracer {

inline constexpr double kTurn = 2 * std::numbers::pi;

/// The angle of (x, y) in turns, 0 <= turns < 1; 0 at the origin.
inline double turns_of(double x, double y) noexcept {
  const double turns = std::atan2(y, x) / kTurn;
  const double positive = turns < 0 ? turns + 1 : turns;
  return positive < 1 ? positive : 0;
}

/// The half-plane from the axis through a point; where the point is on the axis, the one through +x.
struct MeridianPlane {
  double radius;                 // distance from the axis
  glm::dvec3 outwards, around;   // unit; around: where u grows
  double u;
};

inline MeridianPlane meridian_plane(const glm::dvec3& point) noexcept {
  const double radius = std::hypot(point.x, point.z);
  const double x = radius > 0 ? point.x / radius : 1, z = radius > 0 ? point.z / radius : 0;
  return {radius, {x, 0, z}, {z, 0, -x}, turns_of(x, -z)};
}

}  // namespace tuberia::tracer
