#include "pipeline/rasterization.hpp"

namespace tuberia {

void Rasterization::set_up(TriangleBatch& triangles, VertexBatch& vertices, std::vector<ScreenTriangle>& out) const {
  out.resize(static_cast<std::size_t>(triangles.count));
  geometry_.set_up(triangles.arrays(), triangles.count, vertices.screen_arrays(), vertices.clip_w.data(), out.data());
}

std::vector<FragmentBlock> Rasterization::blocks(const ScreenTriangle& triangle, RenderTarget& target) const {
  std::vector<FragmentBlock> found;
  for (int number = 0; number < target.tile_count(); ++number)
    blocks_.rasterize(triangle, target.tile(number), intersection(clip_, target.bounds()), found);
  return found;
}

}  // namespace tuberia
