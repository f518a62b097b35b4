#include "pipeline/perspective_divide.hpp"

namespace tuberia {

ScreenMap screen_map(const Viewport& viewport, const DepthRange& range, ClipVolume volume, int subpixel_bits) noexcept {
  const double half_width = 0.5 * viewport.width_pixels, half_height = 0.5 * viewport.height_pixels;
  const double near_depth = static_cast<double>(range.near_depth), far_depth = static_cast<double>(range.far_depth);
  const double span = far_depth - near_depth;
  const bool from_minus_one = volume == ClipVolume::minus_w_to_w;
  return {.x_scale = half_width, .x_offset = viewport.x + half_width,
          .y_scale = -half_height, .y_offset = viewport.y + half_height,
          .depth_scale = from_minus_one ? 0.5 * span : span,
          .depth_offset = from_minus_one ? 0.5 * (near_depth + far_depth) : near_depth,
          .subpixel_bits = subpixel_bits};
}

void PerspectiveDivide::operator()(VertexBatch& batch) const {
  make_room(batch.screen, static_cast<std::size_t>(batch.size()) + kKernelPadding);
  kernels_.project(batch.clip_arrays(), batch.size(), map_, batch.screen.data());
}

void PerspectiveDivide::take(std::span<const ScreenVertex> vertices, VertexBatch& batch) {
  make_room(batch.screen, static_cast<std::size_t>(batch.size()) + kKernelPadding);
  for (std::size_t slot = 0; slot < batch.source.size(); ++slot) batch.screen[slot] = vertices[batch.source[slot]];
}

}  // namespace tuberia
