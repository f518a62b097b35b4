#pragma once
// A camera as plain data, and the matrices it stands for.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "base/result.hpp"
#include "math/transforms.hpp"

namespace tuberia {

enum class Projection { perspective, orthographic };

/// A view reference system and a frustum [C 2.1]. Positions in world space. The system's axes are those of the look-at [C 2.2], unless
/// a motion has set them (math/camera_motions.hpp), since eye, point and up cannot say them to the last bit wherever the eye moves;
/// reset `basis` to set up the camera by its eye and point again.
/// view: the window and the two distances. Move the window sideways for the off-axis views of
/// stereo pairs and depth of field [C 2.7, 2.9]; perspective_volume makes the usual symmetric one.
struct Camera {
  glm::dvec3 eye{0, 0, 3}, point_of_interest{0, 0, 0}, up{0, 1, 0};
  Projection projection = Projection::perspective;
  ViewVolume view{};
  ClipVolume clip_volume = ClipVolume::minus_w_to_w;
  bool reversed_depth = false;
  std::optional<CameraBasis> basis{};  // orthonormal, looking from eye to point_of_interest
  bool operator==(const Camera&) const = default;
};

/// The camera's axes. Errors of camera_basis, and for a basis that is set but not orthonormal to 1e-9.
Result<CameraBasis> basis_of(const Camera& camera);

/// clip_from_world is the composition of the other two, rounded once.
struct CameraMatrices {
  glm::mat4 view_from_world{1.0f}, clip_from_view{1.0f}, clip_from_world{1.0f};
  bool operator==(const CameraMatrices&) const = default;
};

/// Errors of basis_of and of frustum or orthographic.
Result<CameraMatrices> camera_matrices(const Camera& camera);

/// A wish for a picture of a whole object. centre, radius: its bounding sphere, world space.
/// The eye stands azimuth_degrees around the world's y axis, from +z towards +x, and
/// elevation_degrees above the horizon, -90..90 (straight up and down are allowed).
/// aspect is width / height; fovy_radians in (0, pi).
struct Framing {
  glm::dvec3 centre{0, 0, 0};
  double radius = 1;
  double azimuth_degrees = 30, elevation_degrees = 20;
  double fovy_radians = 0.7853981633974483;  // 45 degrees
  double aspect = 4.0 / 3.0;
  ClipVolume clip_volume = ClipVolume::minus_w_to_w;
  bool operator==(const Framing&) const = default;
};

/// A perspective camera as near as it can be with the whole sphere in view; its near and far
/// planes lie just before and just behind the sphere, near_distance > 0.
/// Error for a parameter out of range.
Result<Camera> framing(const Framing& wish);

/// The framing of the sphere around a box, all else default; smallest <= largest in each
/// coordinate, world space. A box without extent gets the radius 1.
Framing framing_of_box(const glm::dvec3& smallest, const glm::dvec3& largest) noexcept;

}  // namespace tuberia
