#pragma once
// Stage 3: what lies outside the view volume is cut away, before anything is divided by w.

#include "pipeline/cutting.hpp"
#include "pipeline/vertex_batch.hpp"

namespace tuberia {

class Clipping {
 public:
  explicit Clipping(const ClipLimits& limits) noexcept : limits_(limits) {}

  /// Drops triangles that are outside or not finite, cuts those that cross the volume into fans
  /// with new vertices, and leaves the others untouched, all in order. Returns how many were cut.
  int operator()(VertexBatch& vertices, TriangleBatch& triangles) const;

  /// The same, and tells what became of each triangle that is left.
  int operator()(VertexBatch& vertices, TriangleBatch& triangles, PolygonBatch& polygons) const;

  /// Drops lines that are outside or not finite, and cuts those that cross. Returns how many were cut.
  int operator()(VertexBatch& vertices, LineBatch& lines) const;

  /// Drops points that are outside anything, however large they are. Returns 0: none is cut.
  int operator()(const VertexBatch& vertices, PointBatch& points) const;

 private:
  int clip_all(VertexBatch& vertices, TriangleBatch& triangles, PolygonBatch* polygons) const;
  ClipLimits limits_;
};

}  // namespace tuberia
