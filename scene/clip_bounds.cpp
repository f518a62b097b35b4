#include "scene/clip_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "math/transforms.hpp"
#include "pipeline/cutting.hpp"

namespace tuberia {
namespace {

/// What the pipeline's floats may be away from the doubles here, relative to the sum of the sizes: the
/// matrix is rounded once, products and sums seven times, the comparison with w once more: 10 * 2^-24.
constexpr double kRounding = 0x1p-20;

bool add_all(const MeshView& mesh, glm::dvec4& lower, glm::dvec4& upper) {
  if (!mesh.screen_positions.empty() || mesh.vertex_count() == 0) return false;
  lower = glm::dvec4(INFINITY);
  upper = glm::dvec4(-INFINITY);
  // A sum of zeros stays one unless something is not finite.
  double zero = 0;
  const auto add = [&](const glm::dvec4& p) {
    zero += 0 * (p.x + p.y + p.z + p.w);
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  };
  for (const glm::vec3& p : mesh.positions) add(glm::dvec4(p, 1));
  for (const glm::vec4& p : mesh.clip_positions) add(glm::dvec4(p));
  return zero == 0;
}

}  // namespace

ClipBounds::ClipBounds(const DrawCall& draw, const Viewport& viewport) : draw_(draw) {
  const ClipLimits limits = clip_limits(viewport, draw.state.clipping.volume);
  guard_x_ = static_cast<double>(limits.guard_x);
  guard_y_ = static_cast<double>(limits.guard_y);
  z_low_ = static_cast<double>(limits.z_low);
  const TransformState& transform = draw.state.transform;
  if (draw.mesh.clip_positions.empty()) clip_from_box_ = glm::dmat4(compose(transform.clip_from_world, transform.world_from_object));
  are_known_ = add_all(draw.mesh, lower_, upper_) && std::isfinite(range_of({1, 1, 1, 1}).highest) && std::isfinite(range_of({1, 1, 1, 1}).lowest);
}

ClipRange ClipBounds::range_of(const glm::dvec4& plane) const noexcept {
  ClipRange range;
  double size = 0;
  for (int k = 0; k < 4; ++k) {
    double factor = 0, largest_factor = 0;
    for (int row = 0; row < 4; ++row) {
      factor += plane[row] * clip_from_box_[k][row];
      largest_factor += std::abs(plane[row] * clip_from_box_[k][row]);
    }
    range.lowest += std::fmin(factor * lower_[k], factor * upper_[k]);
    range.highest += std::fmax(factor * lower_[k], factor * upper_[k]);
    size += largest_factor * std::fmax(std::abs(lower_[k]), std::abs(upper_[k]));
  }
  return {range.lowest - kRounding * size, range.highest + kRounding * size};
}

bool ClipBounds::is_inside(const glm::dvec4& vertex) const noexcept {
  const glm::dvec4 clip = clip_from_box_ * vertex;
  double size = 0;
  for (int k = 0; k < 4; ++k)
    for (int row = 0; row < 4; ++row) size += std::abs(clip_from_box_[k][row] * vertex[k]);
  const double w = clip.w - kRounding * size;  // w's own rounding, and that of what it is compared with
  return w > 0 && std::abs(clip.x) + kRounding * size <= guard_x_ * w && std::abs(clip.y) + kRounding * size <= guard_y_ * w &&
         clip.z + kRounding * size <= w && clip.z - kRounding * size >= (z_low_ < 0 ? -w : 0.0);
}

bool ClipBounds::are_inside() const noexcept {
  if (!draw_.mesh.screen_positions.empty()) return true;
  if (!are_known_) return false;
  bool by_box = range_of({0, 0, 0, 1}).lowest > 0;
  for (const glm::dvec4& plane : {glm::dvec4(0, 0, 1, -z_low_), glm::dvec4(0, 0, -1, 1), glm::dvec4(1, 0, 0, guard_x_),
                                  glm::dvec4(-1, 0, 0, guard_x_), glm::dvec4(0, 1, 0, guard_y_), glm::dvec4(0, -1, 0, guard_y_)})
    by_box &= range_of(plane).lowest >= 0;
  const MeshView& mesh = draw_.mesh;
  return by_box || (std::all_of(mesh.positions.begin(), mesh.positions.end(), [&](const glm::vec3& p) { return is_inside(glm::dvec4(p, 1)); }) &&
                    std::all_of(mesh.clip_positions.begin(), mesh.clip_positions.end(), [&](const glm::vec4& p) { return is_inside(glm::dvec4(p)); }));
}

bool ClipBounds::are_outside(bool reaches_beyond) const noexcept {
  if (!are_known_) return false;
  const double x = reaches_beyond ? guard_x_ : 1, y = reaches_beyond ? guard_y_ : 1;
  for (const glm::dvec4& plane : {glm::dvec4(0, 0, 1, -z_low_), glm::dvec4(0, 0, -1, 1), glm::dvec4(1, 0, 0, x), glm::dvec4(-1, 0, 0, x),
                                  glm::dvec4(0, 1, 0, y), glm::dvec4(0, -1, 0, y)})
    if (range_of(plane).highest < 0) return true;
  return false;
}

}  // namespace tuberia
