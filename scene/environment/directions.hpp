#pragma once
// Where a direction stands in each kind of environment map, and back: the definitions, in double.
//
// Directions are those of the map's own axes, y up. Points are (u, v) in [0, 1] with (0, 0) at the upper
// left of the image, so v runs down; the notes' t, which runs up, is 1 - v.          [A 1.4] [B 4.1.3]

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace tuberia {

/// A panorama as it is seen from within, looking at -z in its middle and at +x a quarter further right:
/// u = 1/2 + atan2(x, -z) / 2 pi, v = acos(y / length) / pi, v = 0 at the zenith. Any length; the zero
/// vector counts as +z. At the poles u is 1/2.
glm::dvec2 panorama_point(const glm::dvec3& direction) noexcept;

/// The unit direction of a point of a panorama; u repeats with period 1.
glm::dvec3 panorama_direction(const glm::dvec2& point) noexcept;

/// A small mirror ball, as a distant eye on +z sees it with +x to the right and +y up: the point where
/// the ball shows what lies in this direction. With m = 2 |r + (0, 0, 1)| of the unit direction r:
/// u = 1/2 + r.x / m, v = 1/2 - r.y / m. All of the rim shows -z, for which this gives (1, 1/2).
glm::dvec2 sphere_map_point(const glm::dvec3& direction) noexcept;

/// The unit direction that the ball mirrors at a point: r = 2 n.z n - z with the normal n = (2 u - 1,
/// 1 - 2 v, what makes it unit). Beyond the ball it is the rim's, -z.
glm::dvec3 sphere_map_direction(const glm::dvec2& point) noexcept;

/// A point of a face: +x, -x, +y, -y, +z, -z. The faces lie as in raster/cube_map.hpp: seen from
/// outside the cube, so from within each is mirrored.
struct CubeFacePoint {
  int face = 4;
  glm::dvec2 at{0.5, 0.5};
};

/// cube_point in double; the zero vector counts as +z.
CubeFacePoint cube_face_point(const glm::dvec3& direction) noexcept;

/// The direction through a point of a face, or of its plane beyond it: its coordinate along the face's
/// axis is 1 or -1.
glm::dvec3 cube_face_direction(const CubeFacePoint& point) noexcept;

}  // namespace tuberia
