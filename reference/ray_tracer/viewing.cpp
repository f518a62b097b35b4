#include "reference/ray_tracer/viewing.hpp"

#include <glm/geometric.hpp>

#include "math/parameter_error.hpp"

namespace tuberia::tracer {

ViewingSystem viewing_system(const glm::dvec3& E, const glm::dvec3& G, const glm::dvec3& U, const ViewVolume& window) noexcept {
  const glm::dvec3 X = glm::normalize(glm::cross(G, U)), Y = glm::normalize(glm::cross(X, G));
  return {.E = E, .G = G, .X = X, .Y = Y,
          .middle = window.near_distance * G + 0.5 * (window.left + window.right) * X + 0.5 * (window.bottom + window.top) * Y,
          .H = 0.5 * (window.right - window.left) * X, .V = 0.5 * (window.top - window.bottom) * Y};
}

ViewVolume window_of_half_angles(double theta_radians, double phi_radians, double d) noexcept {
  const double right = d * std::tan(theta_radians), top = d * std::tan(phi_radians);
  return {.left = -right, .right = right, .bottom = -top, .top = top, .near_distance = d, .far_distance = kInfinity};
}

glm::dvec3 sight_direction(const CameraBasis& basis, double x_window, double y_window) noexcept {
  return glm::normalize(-basis.w + x_window * basis.u + y_window * basis.v);
}

Result<View> View::create(const Camera& camera, int width_pixels, int height_pixels) {
  if (width_pixels < 1) return parameter_error("width", width_pixels, "at least 1 pixel");
  if (height_pixels < 1) return parameter_error("height", height_pixels, "at least 1 pixel");
  if (const auto matrices = camera_matrices(camera); !matrices) return matrices.error();
  return View(camera, *basis_of(camera), glm::dvec2(width_pixels, height_pixels));
}

View::View(const Camera& camera, const CameraBasis& basis, const glm::dvec2& size_pixels) noexcept
    : basis_(basis), projection_(camera.projection), window_(camera.view), size_(size_pixels),
      system_(viewing_system(camera.eye, -basis.w, basis.v, camera.view)) {}

Ray View::ray(const glm::dvec2& pixel, bool clipped) const noexcept {
  const auto& [E, G, X, Y, middle, H, V] = system_;
  const double x = pixel.x / size_.x, y = 1 - pixel.y / size_.y;
  const bool is_parallel = projection_ == Projection::orthographic;
  const glm::dvec3 S = system_.S(x, y);
  Ray ray{.origin = is_parallel ? S - window_.near_distance * G : E, .direction = is_parallel ? G : glm::normalize(S - E)};
  if (!clipped) return ray;
  const double forwards = glm::dot(ray.direction, G);
  ray.t_min = window_.near_distance / forwards;
  ray.t_max = window_.far_distance / forwards;
  return ray;
}

glm::dvec3 View::sight_line(const glm::dvec2& pixel) const noexcept {
  if (projection_ == Projection::orthographic) return -basis_.w;
  const double x = window_.left + (window_.right - window_.left) * pixel.x / size_.x;
  const double y = window_.top - (window_.top - window_.bottom) * pixel.y / size_.y;
  return sight_direction(basis_, x / window_.near_distance, y / window_.near_distance);
}

}  // namespace tuberia::tracer
