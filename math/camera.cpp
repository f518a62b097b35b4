#include "math/camera.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/parameter_error.hpp"

namespace tuberia {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

// Room between the sphere and the planes, so that rounding cuts nothing off.
constexpr double kPlaneSlack = 1e-3;

Result<Nothing> check(const Framing& wish) {
  const double coordinates[] = {wish.centre.x, wish.centre.y, wish.centre.z};
  for (const double coordinate : coordinates)
    if (!std::isfinite(coordinate)) return parameter_error("centre", coordinate, "finite");
  if (!std::isfinite(wish.radius) || !(wish.radius > 0.0))
    return parameter_error("radius", wish.radius, "finite and greater than 0");
  if (!std::isfinite(wish.azimuth_degrees))
    return parameter_error("azimuth_degrees", wish.azimuth_degrees, "finite");
  if (!(std::abs(wish.elevation_degrees) <= 90.0))
    return parameter_error("elevation_degrees", wish.elevation_degrees, "between -90 and 90");
  if (!(wish.fovy_radians > 0.0 && wish.fovy_radians < std::numbers::pi))
    return parameter_error("fovy_radians", wish.fovy_radians, "greater than 0 and less than pi");
  if (!std::isfinite(wish.aspect) || !(wish.aspect > 0.0))
    return parameter_error("aspect", wish.aspect, "finite and greater than 0");
  return Nothing{};
}

// What a basis may lack to an orthonormal one.
constexpr double kOrthonormal = 1e-9;

}  // namespace

Result<CameraBasis> basis_of(const Camera& camera) {
  if (!camera.basis) return camera_basis(camera.eye, camera.point_of_interest, camera.up);
  const auto& [u, v, w] = *camera.basis;
  const double error = std::max({glm::length(glm::cross(u, v) - w), glm::length(glm::cross(v, w) - u), glm::length(glm::cross(w, u) - v)});
  if (!(error < kOrthonormal)) return Error{"basis is not orthonormal and right-handed"};
  for (const double coordinate : {camera.eye.x, camera.eye.y, camera.eye.z})
    if (!std::isfinite(coordinate)) return parameter_error("eye", coordinate, "finite");
  return *camera.basis;
}

Result<CameraMatrices> camera_matrices(const Camera& camera) {
  const auto basis = basis_of(camera);
  if (!basis) return basis.error();
  const auto project = camera.projection == Projection::perspective ? &frustum : &orthographic;
  const auto clip_from_view = project(camera.view, camera.clip_volume, camera.reversed_depth);
  if (!clip_from_view) return clip_from_view.error();

  CameraMatrices matrices{.view_from_world = view_from_world(*basis, camera.eye),
                          .clip_from_view = *clip_from_view};
  matrices.clip_from_world = compose(matrices.clip_from_view, matrices.view_from_world);
  return matrices;
}

Result<Camera> framing(const Framing& wish) {
  if (const auto checked = check(wish); !checked) return checked.error();

  // The sphere touches the planes of the narrower opening.
  const double half_height = 0.5 * wish.fovy_radians;
  const double half_width = std::atan(std::tan(half_height) * wish.aspect);
  const double distance = wish.radius / std::sin(std::min(half_height, half_width)) * (1.0 + kPlaneSlack);
  const auto view = perspective_volume(wish.fovy_radians, wish.aspect,
                                       (distance - wish.radius) * (1.0 - kPlaneSlack),
                                       (distance + wish.radius) * (1.0 + kPlaneSlack));
  if (!view) return view.error();

  // "Up" is the direction in which the eye moves when the elevation grows: it is perpendicular to
  // the line of sight everywhere, at the poles too.
  const double azimuth = wish.azimuth_degrees * kRadiansPerDegree;
  const double elevation = wish.elevation_degrees * kRadiansPerDegree;
  const glm::dvec3 horizontal(std::sin(azimuth), 0.0, std::cos(azimuth)), vertical(0.0, 1.0, 0.0);
  const glm::dvec3 to_eye = horizontal * std::cos(elevation) + vertical * std::sin(elevation);
  const glm::dvec3 up = vertical * std::cos(elevation) - horizontal * std::sin(elevation);
  return Camera{.eye = wish.centre + to_eye * distance, .point_of_interest = wish.centre, .up = up,
                .projection = Projection::perspective, .view = *view, .clip_volume = wish.clip_volume};
}

Framing framing_of_box(const glm::dvec3& smallest, const glm::dvec3& largest) noexcept {
  const double radius = 0.5 * glm::length(largest - smallest);
  return {.centre = 0.5 * (smallest + largest), .radius = radius > 0.0 ? radius : 1.0};
}

}  // namespace tuberia
