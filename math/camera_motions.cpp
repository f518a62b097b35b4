#include "math/camera_motions.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "math/parameter_error.hpp"

namespace tuberia {
namespace {

std::optional<Error> finite_error(const char* name, double value) {
  if (std::isfinite(value)) return std::nullopt;
  return parameter_error(name, value, "finite");
}

/// a turned by an angle towards b, both unit and perpendicular.
glm::dvec3 turned(const glm::dvec3& a, const glm::dvec3& b, double angle) { return a * std::cos(angle) + b * std::sin(angle); }

/// Rodrigues: a vector turned about a unit axis, counter-clockwise seen against it.
glm::dvec3 turned_about(const glm::dvec3& vector, const glm::dvec3& axis, double angle) {
  return vector * std::cos(angle) + glm::cross(axis, vector) * std::sin(angle) + axis * (glm::dot(axis, vector) * (1 - std::cos(angle)));
}

/// Made orthonormal again after turns, so that rounding does not add up over many: w is kept but for its length, u made
/// perpendicular to it.
CameraBasis orthonormal(const CameraBasis& basis) {
  const glm::dvec3 w = glm::normalize(basis.w);
  const glm::dvec3 u = glm::normalize(basis.u - glm::dot(basis.u, w) * w);
  return {.u = u, .v = glm::cross(w, u), .w = w};
}

/// The camera with other axes, its eye or its point of interest moved along with them.
Camera with_eye_turned(Camera camera, const CameraBasis& basis) {
  const double distance = glm::length(camera.eye - camera.point_of_interest);
  camera.eye = camera.point_of_interest + distance * basis.w;
  camera.up = basis.v;
  camera.basis = basis;
  return camera;
}

/// Turns the axis `first` about another, which is kept, towards the third.
Result<Camera> head_turn(Camera camera, glm::dvec3 CameraBasis::*kept, glm::dvec3 CameraBasis::*first, glm::dvec3 CameraBasis::*third, double angle) {
  if (const auto error = finite_error("angle_radians", angle)) return *error;
  const auto before = basis_of(camera);
  if (!before) return before.error();
  CameraBasis after = *before;
  const glm::dvec3& axis = after.*kept;
  const glm::dvec3 direction = turned(after.*first, after.*third, angle);
  after.*first = glm::normalize(direction - glm::dot(direction, axis) * axis);
  after.*third = glm::cross(axis, after.*first);
  if (after.w != before->w) {
    const double distance = glm::length(camera.eye - camera.point_of_interest);
    camera.point_of_interest = camera.eye - distance * after.w;
  }
  camera.up = after.v;
  camera.basis = after;
  return camera;
}

glm::dvec4 plane_through(const glm::dvec3& inward_normal, const glm::dvec3& point) {
  const glm::dvec3 unit = glm::normalize(inward_normal);
  return {unit, -glm::dot(unit, point)};
}

}  // namespace

Result<Camera> pan(const Camera& camera, double right, double up) {
  if (const auto error = finite_error("right", right)) return *error;
  if (const auto error = finite_error("up", up)) return *error;
  const auto basis = basis_of(camera);
  if (!basis) return basis.error();
  Camera moved = camera;
  const glm::dvec3 offset = right * basis->u + up * basis->v;
  moved.eye += offset;
  moved.point_of_interest += offset;
  moved.basis = *basis;
  return moved;
}

Result<Camera> dolly(const Camera& camera, double forwards) {
  if (const auto error = finite_error("forwards", forwards)) return *error;
  const auto basis = basis_of(camera);
  if (!basis) return basis.error();
  const double distance = glm::dot(camera.eye - camera.point_of_interest, basis->w);
  if (!(forwards < distance)) return parameter_error("forwards", forwards, "less than the distance to the point of interest");
  Camera moved = camera;
  moved.eye -= forwards * basis->w;
  moved.basis = *basis;
  return moved;
}

double vertical_field(const Camera& camera) noexcept {
  return 2.0 * std::atan(0.5 * (camera.view.top - camera.view.bottom) / camera.view.near_distance);
}

Result<Camera> zoom_field(const Camera& camera, double fovy_radians) {
  if (camera.projection != Projection::perspective) return Error{"an orthographic camera has no field of view to zoom by"};
  const auto wanted = perspective_volume(fovy_radians, 1.0, camera.view.near_distance, camera.view.far_distance);
  if (!wanted) return wanted.error();
  Camera zoomed = camera;
  const double factor = 2.0 * wanted->top / (camera.view.top - camera.view.bottom);
  for (double ViewVolume::*side : {&ViewVolume::left, &ViewVolume::right, &ViewVolume::bottom, &ViewVolume::top}) zoomed.view.*side *= factor;
  return zoomed;
}

Result<Camera> orbit(const Camera& camera, const OrbitMotion& motion) {
  if (const auto error = finite_error("right", motion.right)) return *error;
  if (const auto error = finite_error("up", motion.up)) return *error;
  const auto basis = basis_of(camera);
  if (!basis) return basis.error();
  glm::dvec3 vertical = basis->v;
  if (motion.vertical) {
    const double length = glm::length(*motion.vertical);
    if (!(length > 0 && std::isfinite(length))) return Error{"vertical has no direction"};
    vertical = *motion.vertical / length;
  }
  const double sense = motion.inspection ? -1.0 : 1.0;
  const double right = sense * motion.right, up = sense * motion.up;
  CameraBasis axes{.u = turned_about(basis->u, vertical, right), .v = turned_about(basis->v, vertical, right),
                   .w = turned_about(basis->w, vertical, right)};
  axes = {.u = axes.u, .v = turned(axes.v, -axes.w, up), .w = turned(axes.w, axes.v, up)};
  return with_eye_turned(camera, orthonormal(axes));
}

Result<Camera> pitch(const Camera& camera, double angle_radians) {
  return head_turn(camera, &CameraBasis::u, &CameraBasis::v, &CameraBasis::w, angle_radians);
}

Result<Camera> yaw(const Camera& camera, double angle_radians) {
  return head_turn(camera, &CameraBasis::v, &CameraBasis::w, &CameraBasis::u, angle_radians);
}

Result<Camera> roll(const Camera& camera, double angle_radians) {
  return head_turn(camera, &CameraBasis::w, &CameraBasis::u, &CameraBasis::v, angle_radians);
}

Result<std::array<glm::dvec4, 6>> frustum_planes(const Camera& camera) {
  if (const auto checked = camera_matrices(camera); !checked) return checked.error();
  const auto basis = basis_of(camera);
  const glm::dvec3 u = basis->u, v = basis->v, w = basis->w;
  const ViewVolume& view = camera.view;
  const bool parallel = camera.projection == Projection::orthographic;
  // The sides of a perspective volume pass through the eye, those of a parallel one through the window's edges.
  const auto side = [&](const glm::dvec3& axis, double edge, double inwards) {
    if (parallel) return plane_through(inwards * axis, camera.eye + edge * axis);
    return plane_through(inwards * (view.near_distance * axis + edge * w), camera.eye);
  };
  const auto end = [&](double distance, const glm::dvec3& inward_normal) {
    return std::isfinite(distance) ? plane_through(inward_normal, camera.eye - distance * w) : glm::dvec4(0, 0, 0, 1);
  };
  return std::array<glm::dvec4, 6>{side(u, view.left, 1), side(u, view.right, -1), side(v, view.bottom, 1), side(v, view.top, -1),
                                   end(view.near_distance, -w), end(view.far_distance, w)};
}

}  // namespace tuberia
