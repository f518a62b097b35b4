#pragma once
// Where all of a draw lies in clip space, as far as the box around its vertices tells.

#include <glm/vec4.hpp>

#include "math/spaces.hpp"
#include "pipeline/draw_call.hpp"

namespace tuberia {

/// Between which values a linear function of clip space lies at all vertices; roundings included.
struct ClipRange {
  double lowest = 0, highest = 0;
};

class ClipBounds {
 public:
  /// Looks at every position once, whether an index uses it or not. viewport: the draw's, or the whole target.
  ClipBounds(const DrawCall& draw, const Viewport& viewport);

  /// False when a position is not finite or the box is too large for doubles: then nothing is known.
  bool are_known() const noexcept { return are_known_; }
  /// Of plane . (x, y, z, w). Only where bounds are known, and positions are not given on the screen.
  ClipRange range_of(const glm::dvec4& plane) const noexcept;

  /// Whether no vertex is outside of the near and far plane or the guard band, or behind the eye: nothing to cut.
  /// Looks at the vertices where the box does not tell.
  bool are_inside() const noexcept;
  /// Whether all vertices are outside one same plane, so that nothing is drawn. reaches_beyond: what is
  /// drawn may be wider than its vertices, as points and lines are; then the guard band counts, not the viewport.
  bool are_outside(bool reaches_beyond) const noexcept;

 private:
  bool is_inside(const glm::dvec4& vertex) const noexcept;

  const DrawCall& draw_;
  glm::dmat4 clip_from_box_{1.0};
  glm::dvec4 lower_{0, 0, 0, 1}, upper_{0, 0, 0, 1};  // the box, and 1 (of clip positions: and w)
  double guard_x_ = 1, guard_y_ = 1, z_low_ = -1;
  bool are_known_ = false;
};

}  // namespace tuberia
