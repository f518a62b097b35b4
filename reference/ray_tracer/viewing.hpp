#pragma once
// Rays from the eye through the picture.                                 [A 2.1] [B 5.2] [C]

#include "base/result.hpp"
#include "math/camera.hpp"
#include "reference/ray_tracer/ray.hpp"

namespace tuberia::tracer {

/// The viewing system in the letters of the notes: the eye E; the unit directions G of sight, X to the right and Y up in the
/// picture; a window whose middle stands at E + middle, and H and V from there to its right and its upper side.        [B Fig 33]
struct ViewingSystem {
  glm::dvec3 E, G, X, Y, middle, H, V;

  /// The point of the window for (0, 0) at its lower left corner to (1, 1) at its upper right one, world space.
  glm::dvec3 S(double x, double y) const noexcept { return E + middle + (2 * x - 1) * H + (2 * y - 1) * V; }
};

/// G: towards the reference point, unit.   U: up, not parallel to G.   window: on the plane at its near_distance, the notes' d;
/// the middle is at d G unless it is moved off the axis.                                                                   [B 5.2]
ViewingSystem viewing_system(const glm::dvec3& E, const glm::dvec3& G, const glm::dvec3& U, const ViewVolume& window) noexcept;

/// The notes' window, d tan(theta) and d tan(phi) to each side; square pixels: tan(phi) = tan(theta) height / width.      [B 5.2]
ViewVolume window_of_half_angles(double theta_radians, double phi_radians, double d) noexcept;

/// The direction through a point of the window on the plane at distance 1, in world units from the axis; unit.       [C] [FIX 1]
glm::dvec3 sight_direction(const CameraBasis& basis, double x_window, double y_window) noexcept;

/// A camera's rays for a picture of width x height pixels.
class View {
 public:
  /// Errors of camera_matrices; a width or height below 1.
  static Result<View> create(const Camera& camera, int width_pixels, int height_pixels);

  /// The ray through a point of the picture in pixels, (0, 0) its upper left corner, so that pixel (i, j) has its centre at (i + 1/2, j + 1/2).
  /// Unit direction; from the eye of a perspective, from the eye's plane of a parallel view. t begins at the near plane and
  /// ends at the far one if `clipped`, as the pipeline has it.
  Ray ray(const glm::dvec2& pixel, bool clipped = false) const noexcept;

  /// The same direction by the other notes' formula, for comparison.                                                         [C]
  glm::dvec3 sight_line(const glm::dvec2& pixel) const noexcept;

  const ViewingSystem& system() const noexcept { return system_; }

 private:
  View(const Camera& camera, const CameraBasis& basis, const glm::dvec2& size_pixels) noexcept;

  CameraBasis basis_;
  Projection projection_;
  ViewVolume window_;
  glm::dvec2 size_;
  ViewingSystem system_;
};

}  // namespace tuberia::tracer
