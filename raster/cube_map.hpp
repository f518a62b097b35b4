#pragma once
// Cube maps: which point of which face a direction meets.

#include <glm/vec3.hpp>

namespace tuberia {

/// A point of a cube map: its face, and coordinates on it in [0, 1] with (0, 0) at the upper left.
struct CubePoint {
  int face = 4;  // +x, -x, +y, -y, +z, -z
  float s = 0, t = 0;
  bool operator==(const CubePoint&) const = default;
};

/// Where a direction (of any length) leaves the cube around the origin. The largest coordinate names
/// the face; of equal ones z comes before y before x [rules T5]. s and t are (c / m + 1) / 2 in float
/// with m the largest coordinate's size and c this face's own two coordinates:
///   +x: -z, -y    -x: z, -y    +y: x, z    -y: x, -z    +z: x, -y    -z: -x, -y
/// The zero vector gives face 4 and s = t = 0; so does any NaN among its coordinates for the
/// coordinate that it spoils.
CubePoint cube_point(const glm::vec3& direction) noexcept;

/// The direction through a point of a face: its largest coordinate is 1 or -1.
glm::vec3 cube_direction(const CubePoint& point) noexcept;

}  // namespace tuberia
