#include "scene/content/scene_camera.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "math/camera_motions.hpp"

namespace tuberia {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

Result<Camera> standing(const description::Camera& from, double aspect) {
  Camera camera{.eye = from.eye, .point_of_interest = from.look_at, .up = from.up};
  if (from.kind == description::Camera::Kind::orthographic) {
    const double half = from.height / 2;
    camera.projection = Projection::orthographic;
    camera.view = {.left = -half * aspect, .right = half * aspect, .bottom = -half, .top = half, .near_distance = from.near_distance, .far_distance = from.far_distance};
    return camera;
  }
  const auto volume = perspective_volume(from.fovy_degrees * kRadiansPerDegree, aspect, from.near_distance, from.far_distance);
  if (!volume) return volume.error();
  camera.view = *volume;
  return camera;
}

/// So many times larger after the whole of it.
Result<Camera> zoomed(const Camera& camera, double factor) {
  return zoom_field(camera, 2 * std::atan(std::tan(vertical_field(camera) / 2) / factor));
}

/// The part of a motion that is done at a time.
Result<Camera> moved(const Camera& camera, const description::CameraMotion& motion, double time) {
  using Kind = description::CameraMotion::Kind;
  const double turn = time * kRadiansPerDegree;
  switch (motion.kind) {
    case Kind::pan: return pan(camera, time * motion.right, time * motion.up);
    case Kind::dolly: return dolly(camera, time * motion.distance);
    case Kind::zoom: return zoomed(camera, std::pow(motion.factor, time));
    case Kind::orbit: return orbit(camera, {.right = turn * motion.right_degrees, .up = turn * motion.up_degrees, .inspection = motion.inspection});
    case Kind::turn: break;
  }
  Result<Camera> turned = pitch(camera, turn * motion.pitch_degrees);
  if (turned) turned = yaw(*turned, turn * motion.yaw_degrees);
  if (turned) turned = roll(*turned, turn * motion.roll_degrees);
  return turned;
}

}  // namespace

Result<Camera> camera_of(const description::Camera& from, double aspect, double time) {
  Result<Camera> camera = standing(from, aspect);
  if (time == 0) return camera;
  for (std::size_t i = 0; camera && i < from.motions.size(); ++i) {
    camera = moved(*camera, from.motions[i], time);
    if (!camera) return Error{"motion " + std::to_string(i) + ": " + camera.error().message};
  }
  return camera;
}

glm::vec3 eye_of(const Camera& camera) noexcept {
  if (camera.projection == Projection::perspective) return glm::vec3(camera.eye);
  constexpr double kFarAway = 1e4;  // depths of the view
  const glm::dvec3 backwards = glm::normalize(camera.eye - camera.point_of_interest);
  return glm::vec3(camera.eye + kFarAway * camera.view.far_distance * backwards);
}

}  // namespace tuberia
