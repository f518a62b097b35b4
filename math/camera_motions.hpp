#pragma once
// How a camera is moved by hand [C 2.8]. Each motion keeps what the notes say it keeps, to the last bit: it stores the
// axes in Camera::basis and never computes again what it does not change. Motions that turn the camera set `up` to its v,
// so that eye, point of interest and up say the same as the basis, to rounding.
//
// All return the errors of basis_of, an error for an angle or length that is not finite, and those listed below.

#include <array>
#include <glm/ext/vector_double4.hpp>
#include <optional>

#include "math/camera.hpp"

namespace tuberia {

/// Moves eye and point of interest together by right * u + up * v, world units.
/// Keeps the axes, up and the view volume.
Result<Camera> pan(const Camera& camera, double right, double up);

/// Zoom by distance: moves the eye by `forwards` along -w; negative: away. Keeps the point of interest, the axes, up and
/// the view volume. Error when the eye would reach the point of interest or pass it.
Result<Camera> dolly(const Camera& camera, double forwards);

/// Zoom by field: the view volume's window for a vertical opening in (0, pi), an off-axis one scaled alike in both directions.
/// Keeps all else. Error for an orthographic camera, which has no field.
Result<Camera> zoom_field(const Camera& camera, double fovy_radians);

/// The vertical opening of a perspective camera with a symmetric window, radians; of others, that of a window as high.
double vertical_field(const Camera& camera) noexcept;

/// How far the eye goes around the point of interest, radians.
struct OrbitMotion {
  double right = 0;                 // about v, or about `vertical`: the eye moves towards u
  double up = 0;                    // about u: the eye moves towards v
  std::optional<glm::dvec3> vertical{};  // the world's vertical, for left and right; unset: the camera's v
  bool inspection = false;          // senses inverted: the object seems to be turned in the hand
};

/// First to the right, then up. Keeps the point of interest, the eye's distance from it and the view volume. Error for a vertical
/// without direction.
Result<Camera> orbit(const Camera& camera, const OrbitMotion& motion);

/// Turns of the head, in the camera's own system, counter-clockwise seen against the axis: pitch about u raises the view, yaw
/// about v turns it to the left, roll about w leans the head to the left (the image turns clockwise). Keep the eye, the view volume, the distance
/// of the point of interest, which moves with the view, and the axis that they turn about.
Result<Camera> pitch(const Camera& camera, double angle_radians);
Result<Camera> yaw(const Camera& camera, double angle_radians);
Result<Camera> roll(const Camera& camera, double angle_radians);

/// The view volume's planes in world space, normals unit and inwards: plane . (x, y, z, 1) is the distance of a
/// point, >= 0 inside. In the order left, right, bottom, top, near, far; (0, 0, 0, 1) for a far plane at infinity.  [C 2.1]
/// Errors of camera_matrices.
Result<std::array<glm::dvec4, 6>> frustum_planes(const Camera& camera);

}  // namespace tuberia
