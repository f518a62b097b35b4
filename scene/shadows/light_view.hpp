#pragma once
// A light as an observer: what it sees is lit.                                              [A 1.3]

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "base/result.hpp"
#include "math/camera.hpp"
#include "pipeline/lighting.hpp"
#include "scene/bounds.hpp"

namespace tuberia {

/// A light's view of the world, and the picture that it gives or throws.
struct LightView {
  Camera camera;
  glm::mat4 clip_from_world{1.0f};
  glm::mat4 map_from_world{1.0f};  // to (s, t, depth, 1) times w: (0, 0) upper left, depth 0 near and 1 far
  glm::vec3 right{1, 0, 0}, down{0, -1, 0};  // what the picture's sides span where w is 1, world units
  float position_error = 0;        // about how far rounding may move a point that the light sees, world units
};

/// Any camera in place of a light: a spot or a projector that is aimed by hand. w is the distance along the
/// line of sight, or 1 in a parallel view. Errors of camera_matrices, and for reversed depth.
Result<LightView> light_view(const Camera& camera);

/// The camera that shows a light the whole of a box (world space) and little more: a parallel view for a
/// directional light, a perspective one for a point; for a spot, of the box what lies in its cone. Error for
/// an empty box, numbers that are not finite, a direction that is zero, a point light that is not outside of
/// the box, and a spot that sees nothing of it. Spots wider than 80 degrees from their axis count as points.
Result<Camera> light_camera(const Light& light, const Bounds& seen);

/// light_view of light_camera, with the errors of both.
Result<LightView> light_view(const Light& light, const Bounds& seen);

/// A point light that looks all around, through the six faces of a cube: +x, -x, +y, -y, +z, -z.
struct LightCube {
  glm::dvec3 position{0};                             // world space
  double near_distance = 0.01, far_distance = 10;     // along each face's axis, world units
};

/// What shows a light everything in a box, but for what is next to it: nearer than a thousandth of the
/// farthest. Error for a light that is not a point, an empty box, and numbers that are not finite.
Result<LightCube> light_cube(const Light& light, const Bounds& seen);

/// The view through one face. Its picture is the face mirrored left to right: see cube_face_camera.
Result<LightView> light_view(const LightCube& cube, int face);

}  // namespace tuberia
