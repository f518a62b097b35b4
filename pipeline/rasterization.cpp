#include "pipeline/rasterization.hpp"

#include <algorithm>

namespace tuberia {

void Rasterization::set_up(TriangleBatch& triangles, const VertexBatch& vertices, std::vector<ScreenTriangle>& out) const {
  out.resize(static_cast<std::size_t>(triangles.count));
  geometry_.set_up(triangles.arrays(), triangles.count, vertices.screen.data(), has_samples_, out.data());
  if (edges_ == EdgeArithmetic::exact) return;
  for (ScreenTriangle& record : out) {
    record.is_near = 0;
    record.edge_arithmetic = edges_;
  }
}

void Rasterization::choose_perspective(PerspectiveCorrection correction, std::span<ScreenTriangle> records) noexcept {
  if (correction == PerspectiveCorrection::each_pixel) return;
  constexpr std::uint8_t kSegment[] = {kDividesEachPixel, 8, 16, 32, kIsAffine};
  const std::uint8_t chosen = kSegment[static_cast<std::size_t>(correction)];
  for (ScreenTriangle& record : records)
    if (record.perspective == kDividesEachPixel) record.perspective = chosen;
}

void Rasterization::choose_faces(const VertexBatch& vertices, std::span<ScreenTriangle> records) noexcept {
  if (vertices.back_slots == 0) return;
  for (ScreenTriangle& record : records) {
    if (record.is_back == 0) continue;
    for (std::uint16_t& slot : record.vertex) slot = static_cast<std::uint16_t>(slot + vertices.back_slots);
    record.provoking_vertex = static_cast<std::uint16_t>(record.provoking_vertex + vertices.back_slots);
  }
}

void Rasterization::measure(std::span<const ScreenTriangle> records, std::vector<TriangleExtent>& out) {
  if (out.size() < records.size()) out.resize(records.size());
  std::transform(records.begin(), records.end(), out.begin(), extent_of);
}

std::vector<FragmentBlock> Rasterization::blocks(const ScreenTriangle& triangle, RenderTarget& target) const {
  std::vector<FragmentBlock> found;
  for (int number = 0; number < target.tile_count(); ++number)
    blocks_.rasterize(triangle, target.tile(number), intersection(clip_, target.bounds()), found);
  return found;
}

}  // namespace tuberia
