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
// tiles are cheap. Slots must fit 16 bits: 3 vertices and at most 17 clipped corners a primitive; and
// where faces have colours of their own, as many again.
inline constexpr int kPrimitivesPerChunk = 2048;
inline constexpr int kTwoSidedPrimitivesPerChunk = 1024;
static_assert(kPrimitivesPerChunk * 20 < 65536 && kTwoSidedPrimitivesPerChunk * 40 < 65536);

struct Chunk {
  PrimitiveRange range;
  VertexFetch fetch;
  std::vector<std::uint32_t> slots;
  VertexBatch vertices;
  TriangleBatch triangles;
  LineBatch lines;
  PointBatch points;
  PolygonBatch polygons;            // only between clipping and culling, and for polygon modes
  std::vector<ScreenTriangle> screen_triangles;
  std::vector<TriangleExtent> extents;
  std::vector<ScreenShape> shapes;  // empty when all are triangles
  std::uint32_t stipple_advance = 0;  // how far the chunk's part of a line strip moves the pattern on
  TileLists tiles;
  DrawStatistics statistics;

  /// How many triangles, lines and points there are at the moment.
  std::int64_t primitives() const noexcept { return triangles.count + static_cast<std::int64_t>(lines.size() + points.size()); }

  ChunkView view() const noexcept {
    return {.triangles = screen_triangles.data(), .extents = extents.data(), .attributes = vertices.attributes.data(), .stride = vertices.stride,
            .shapes = shapes.empty() ? nullptr : shapes.data(),
            .fog = vertices.fog_coordinates.empty() ? nullptr : vertices.fog_coordinates.data()};
  }
};

}  // namespace tuberia
