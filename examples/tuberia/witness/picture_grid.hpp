#pragma once
// Where the pipeline puts a triangle's corners: on a grid of 1/256 pixel.                        [rules R1, P1]

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "math/camera.hpp"

namespace tuberia::witness {

class PictureGrid {
 public:
  PictureGrid(const Camera& camera, const CameraBasis& basis, const glm::ivec2& size_pixels)
      : eye_(camera.eye), basis_(basis), view_(camera.view), is_parallel_(camera.projection == Projection::orthographic), size_(size_pixels) {}

  bool is_parallel() const { return is_parallel_; }

  /// A point of the world in pixels, not rounded, and w: its distance along the line of sight, or 1 in a parallel view.
  glm::dvec3 screen_from_world(const glm::dvec3& point) const;

  /// The second and third corner's shares of what is interpolated at a place of the picture (pixels), perspective-correct,
  /// with the corners on the grid; inside of the triangle or not. Nothing for a triangle that reaches behind the near plane, which
  /// is cut before it gets there, or has no area.
  std::optional<glm::dvec2> weights_at(const std::array<glm::dvec3, 3>& corners, const glm::dvec2& place) const;

 private:
  glm::dvec3 eye_;
  CameraBasis basis_;
  ViewVolume view_;
  bool is_parallel_;
  glm::dvec2 size_;
};

}  // namespace tuberia::witness
