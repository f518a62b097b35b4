#pragma once
// The environment behind everything else, as far away as the sky.

#include <array>
#include <glm/vec4.hpp>

#include "base/result.hpp"
#include "math/camera.hpp"
#include "pipeline/draw_call.hpp"
#include "pipeline/programs/environment_map.hpp"

namespace tuberia {

/// A triangle that covers the viewport, on the far plane, and at its corners the directions in which the
/// camera sees them. Draw it first, or last to shade only what nothing hides; it writes no depth.
class Background {
 public:
  /// Errors of camera_basis; and a window or near distance that is not finite.
  static Result<Background> create(const Camera& camera);

  /// Refers to this object, which must outlive the draw.
  DrawCall draw(const EnvironmentMap& map) const;

 private:
  Background() = default;
  std::array<glm::vec4, 3> clip_positions_{}, directions_{};
  PipelineState state_;
};

}  // namespace tuberia
