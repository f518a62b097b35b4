#pragma once
// Rays from the eye through the picture.                                 [A 2.1] [B 5.2] [C]

#include "base/result.hpp"
#include "math/camera.hpp"
#include "reference/ray_tracer/ray.hpp"

namespace tuberia::tracer {

/// A camera's rays for a picture of width x height pixels.
class View {
 public:
  /// Errors of basis_of; a width or height below 1.
  static Result<View> create(const Camera& camera, int width_pixels, int height_pixels);

  /// The ray through a point of the picture in pixels, (0, 0) its upper left corner, so that pixel (i, j) has its centre at (i + 1/2, j + 1/2).
  /// Unit direction; from the eye of a perspective, from the eye's plane of a parallel view. t begins at the near plane and
  /// ends at the far one if `clipped`, as the pipeline has it.
  Ray ray(const glm::dvec2& pixel, bool clipped = false) const noexcept;
};

}  // namespace tuberia::tracer
