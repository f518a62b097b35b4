#include "pipeline/draw_order.hpp"

#include <algorithm>
#include <glm/mat4x4.hpp>
#include <optional>

#include "math/transforms.hpp"

namespace tuberia {
namespace {

/// Depth before the viewport, -1..1, of the vertex that an element of the draw names; none behind the eye.
std::optional<float> depth_at(const MeshView& mesh, const glm::mat4& clip_from_object, std::size_t element) {
  const std::size_t vertex = mesh.indices.empty() ? element : mesh.indices[element];
  if (!mesh.screen_positions.empty()) return mesh.screen_positions[vertex].depth;
  const glm::vec4 clip = !mesh.clip_positions.empty() ? mesh.clip_positions[vertex] : clip_from_object * glm::vec4(mesh.positions[vertex], 1);
  if (!(clip.w > 0)) return {};
  return std::clamp(clip.z / clip.w, -1.0f, 1.0f);
}

/// Whether depths grow (> 0) or shrink (< 0) in the order of submission: their covariance with it.
double depth_trend(const DrawCall& draw) {
  constexpr std::size_t kLooks = 64;
  const glm::mat4 clip_from_object = compose(draw.state.transform.clip_from_world, draw.state.transform.world_from_object);
  const std::size_t elements = draw.mesh.element_count(), looks = std::min(elements, kLooks);
  double count = 0, order_sum = 0, depth_sum = 0, product_sum = 0;
  for (std::size_t i = 0; i < looks; ++i) {
    const std::optional<float> depth = depth_at(draw.mesh, clip_from_object, i * elements / looks);
    if (!depth) continue;
    const double order = static_cast<double>(i), z = static_cast<double>(*depth);
    count += 1;
    order_sum += order;
    depth_sum += z;
    product_sum += order * z;
  }
  return product_sum * count - order_sum * depth_sum;
}

}  // namespace

DrawOrder choose_draw_order(const DrawCall& draw, const AcceptedDraw& accepted) {
  const DepthState& depth = accepted.output.depth;
  if (!is_order_free(accepted.output)) return DrawOrder::as_submitted;
  if (!keeps_nearest(depth)) return DrawOrder::last_first;
  const DepthRange& range = draw.state.viewport.depth_range;
  const bool is_mirrored = draw.mesh.screen_positions.empty() && range.near_depth > range.far_depth;
  const bool greater_passes = depth.test == Compare::greater || depth.test == Compare::greater_equal;
  const double farther_later = (is_mirrored != greater_passes) ? -depth_trend(draw) : depth_trend(draw);
  return farther_later < 0 ? DrawOrder::last_first : DrawOrder::as_submitted;
}

}  // namespace tuberia
