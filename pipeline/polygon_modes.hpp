#pragma once
// Culling, where polygons may be drawn as their edges or corners: clipped triangles, whole, become
// filled triangles, lines or points.

#include <span>

#include "pipeline/polygon_offset.hpp"
#include "pipeline/state.hpp"
#include "pipeline/vertex_batch.hpp"

namespace tuberia {

constexpr bool only_fills(const RasterizationState& state) noexcept {
  return state.front_mode == PolygonMode::fill && state.back_mode == PolygonMode::fill;
}

class PolygonModes {
 public:
  /// clip: the pixels that may be drawn; samples: of each; edge_flags: of the mesh's vertices, empty
  /// when all edges are drawn.
  PolygonModes(const PipelineState& state, const PixelRect& clip, int samples, DepthFormat format,
               std::span<const std::uint8_t> edge_flags) noexcept;

  /// Judges each polygon by its whole area, and deals those that stay out to the batches, in order.
  /// Filled triangles come out clockwise, as Culling leaves them.                     [C 3.9]
  void operator()(const VertexBatch& vertices, const PolygonBatch& polygons, TriangleBatch& triangles, LineBatch& lines,
                  PointBatch& points) const;

 private:
  struct Face {
    bool is_back;
    double depth_bias;
  };
  double bias_of(const VertexBatch& vertices, std::span<const PolygonCorner> corners) const;
  bool holds_a_centre(const VertexBatch& vertices, const std::uint32_t (&slot)[3]) const;
  /// Whether the edge that begins at vertex k of the triangle is one to draw.
  bool is_flagged(const VertexBatch& vertices, const ClippedTriangle& triangle, int k) const;
  void fill(const VertexBatch&, const ClippedTriangle&, std::span<const PolygonCorner>, bool is_back, TriangleBatch&) const;
  void outline(const VertexBatch&, const ClippedTriangle&, std::span<const PolygonCorner>, Face, LineBatch&) const;
  void mark_corners(const VertexBatch&, const ClippedTriangle&, std::span<const PolygonCorner>, Face, PointBatch&) const;

  CullingState culling_;
  PolygonMode front_mode_, back_mode_;
  PixelRect clip_;
  int margin_units_;
  PolygonOffsetting offset_;
  std::span<const std::uint8_t> edge_flags_;
};

}  // namespace tuberia
