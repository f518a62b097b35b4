#pragma once
// A run of a draw's primitives on their way through the geometry stages, and what the tiles need
// of them afterwards.

#include <vector>

#include "pipeline/draw_call.hpp"
#include "pipeline/vertex_batch.hpp"
#include "pipeline/vertex_fetch.hpp"
#include "raster/binning.hpp"

namespace tuberia {

// Small enough for a core's second cache with all its vertices, large enough that the lists of
// tiles are cheap. Slots must fit 16 bits: 3 vertices and at most 9 clipped corners a primitive.
inline constexpr int kPrimitivesPerChunk = 2048;
static_assert(kPrimitivesPerChunk * 12 < 65536);

struct Chunk {
  PrimitiveRange range;
  VertexFetch fetch;
  std::vector<std::uint32_t> slots;
  VertexBatch vertices;
  TriangleBatch triangles;
  std::vector<ScreenTriangle> screen_triangles;
  std::vector<ScreenShape> shapes;  // empty when all are triangles
  TileLists tiles;
  DrawStatistics statistics;

  ChunkView view() const noexcept {
    return {.triangles = screen_triangles.data(), .attributes = vertices.attributes.data(), .stride = vertices.stride,
            .shapes = shapes.empty() ? nullptr : shapes.data(),
            .fog = vertices.fog_coordinates.empty() ? nullptr : vertices.fog_coordinates.data()};
  }
};

}  // namespace tuberia
