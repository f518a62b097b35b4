#include "pipeline/validate_geometry.hpp"

#include <cmath>
#include <string>

#include "raster/render_target.hpp"

namespace tuberia {
namespace {

Refusal check_matrix(const char* name, const glm::mat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(matrix[column][row]))
        return Error{std::string(name) + " has " + words_of(matrix[column][row]) + " in row " + std::to_string(row) + ", column " +
                     std::to_string(column)};
  return {};
}

Refusal check_user_planes(const ClippingState& state) {
  if (state.user_plane_count < 0 || state.user_plane_count > ClippingState::kMaxUserPlanes)
    return Error{"user_plane_count is " + std::to_string(state.user_plane_count) + "; 0 to " +
                 std::to_string(ClippingState::kMaxUserPlanes) + " are possible"};
  for (int k = 0; k < state.user_plane_count; ++k)
    for (int i = 0; i < 4; ++i)
      if (!std::isfinite(state.user_planes[static_cast<std::size_t>(k)][i]))
        return Error{"user plane " + std::to_string(k) + " has " + words_of(static_cast<float>(state.user_planes[static_cast<std::size_t>(k)][i])) +
                     " as its " + "xyzw"[i] + "; it must be finite"};
  return {};
}

Refusal check_rasterization(const RasterizationState& state) {
  if (state.subpixel_bits < 0 || state.subpixel_bits > kSubpixelBits)
    return Error{"rasterization.subpixel_bits is " + std::to_string(state.subpixel_bits) + ", outside 0 to " + std::to_string(kSubpixelBits)};
  if (auto refusal = check_range("point size_pixels", state.point.size_pixels, 1.0f / 256, 2048)) return refusal;
  if (auto refusal = check_range("line width_pixels", state.line.width_pixels, 1, 2048)) return refusal;
  if (state.line.stipple && (state.line.stipple->factor < 1 || state.line.stipple->factor > 256))
    return Error{"the stipple factor is " + std::to_string(state.line.stipple->factor) + ", outside 1 to 256"};
  if (auto refusal = check_finite("the polygon offset's factor", state.polygon_offset.factor)) return refusal;
  if (auto refusal = check_finite("the polygon offset's units", state.polygon_offset.units)) return refusal;
  return check_finite("the polygon offset's clamp", state.polygon_offset.clamp);
}

}  // namespace

Refusal check_geometry(const PipelineState& state) {
  const TransformState& transform = state.transform;
  if (auto refusal = check_matrix("world_from_object", transform.world_from_object)) return refusal;
  if (auto refusal = check_matrix("clip_from_world", transform.clip_from_world)) return refusal;
  if (auto refusal = check_matrix("view_from_world", transform.view_from_world)) return refusal;
  if (auto refusal = check_user_planes(state.clipping)) return refusal;
  return check_rasterization(state.rasterization);
}

Refusal check_viewport(const Viewport& viewport, const DepthRange& range) {
  constexpr int kMost = RenderTarget::kMaxSize;
  const auto within = [](int x, int low) { return x >= low && x <= kMost; };
  if (!within(viewport.width_pixels, 0) || !within(viewport.height_pixels, 0) || !within(viewport.x, -kMost) ||
      !within(viewport.y, -kMost))
    return Error{"the viewport " + std::to_string(viewport.width_pixels) + "x" + std::to_string(viewport.height_pixels) +
                 " at (" + std::to_string(viewport.x) + ", " + std::to_string(viewport.y) + ") is out of range: sizes 0 to " +
                 std::to_string(kMost) + ", corners within +-" + std::to_string(kMost)};
  const auto in_unit = [](float depth) { return depth >= 0 && depth <= 1; };
  if (!in_unit(range.near_depth) || !in_unit(range.far_depth))
    return Error{"the depth range " + words_of(range.near_depth) + " to " + words_of(range.far_depth) +
                 " leaves [0, 1]"};
  return {};
}

}  // namespace tuberia
