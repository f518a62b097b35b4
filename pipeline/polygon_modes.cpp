#include "pipeline/polygon_modes.hpp"

#include <algorithm>

#include "math/edge_function.hpp"

namespace tuberia {
namespace {

SnappedPoint place(const VertexBatch& vertices, std::uint32_t slot) { return {vertices.screen[slot].x, vertices.screen[slot].y}; }

/// Twice the area of triangle i of a polygon's fan.
std::int64_t fan_area(const VertexBatch& vertices, std::span<const PolygonCorner> corners, std::size_t i) {
  return twice_area(place(vertices, corners[0].slot), place(vertices, corners[i].slot), place(vertices, corners[i + 1].slot));
}

}  // namespace

PolygonModes::PolygonModes(const PipelineState& state, const PixelRect& clip, int samples, DepthFormat format,
                           std::span<const std::uint8_t> edge_flags) noexcept
    : culling_(state.culling), front_mode_(state.rasterization.front_mode), back_mode_(state.rasterization.back_mode), clip_(clip),
      margin_units_(samples > 1 ? kSubpixelUnits : 0), offset_(state.rasterization.polygon_offset, format),
      // The edges of strips and fans are all drawn.
      edge_flags_(state.assembly.topology == Topology::triangles ? edge_flags : std::span<const std::uint8_t>{}) {}

void PolygonModes::operator()(const VertexBatch& vertices, const PolygonBatch& polygons, TriangleBatch& triangles,
                              LineBatch& lines, PointBatch& points) const {
  triangles.clear();
  lines.clear();
  points.clear();
  if (clip_.empty()) return;
  for (const ClippedTriangle& polygon : polygons.polygons) {
    const std::span corners = std::span(polygons.corners).subspan(polygon.first_corner, polygon.corner_count);
    std::int64_t area = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) area += fan_area(vertices, corners, i);
    // Polygons without area count as turned away.
    const bool is_back = area == 0 || (area > 0) != (culling_.front_face == Winding::clockwise);
    if (culling_.cull == (is_back ? CullFace::back : CullFace::front)) continue;
    const PolygonMode mode = is_back ? back_mode_ : front_mode_;
    if (mode == PolygonMode::fill) {
      fill(vertices, polygon, corners, is_back, triangles);
      continue;
    }
    const Face face{is_back, offset_.applies_to(mode) ? bias_of(vertices, corners) : 0};
    if (mode == PolygonMode::line) outline(vertices, polygon, corners, face, lines);
    else mark_corners(vertices, polygon, corners, face, points);
  }
}

double PolygonModes::bias_of(const VertexBatch& vertices, std::span<const PolygonCorner> corners) const {
  std::size_t first = 1;
  while (first + 2 < corners.size() && fan_area(vertices, corners, first) == 0) ++first;
  if (fan_area(vertices, corners, first) == 0) first = 1;
  return offset_.bias(vertices, corners[0].slot, corners[first].slot, corners[first + 1].slot);
}

bool PolygonModes::holds_a_centre(const VertexBatch& vertices, const std::uint32_t (&slot)[3]) const {
  const auto [left, right] = std::minmax({vertices.screen[slot[0]].x, vertices.screen[slot[1]].x, vertices.screen[slot[2]].x});
  const auto [top, bottom] = std::minmax({vertices.screen[slot[0]].y, vertices.screen[slot[1]].y, vertices.screen[slot[2]].y});
  const auto holds = [&](std::int32_t low, std::int32_t high, int first, int last) {
    const std::int32_t from = -((kPixelCentre + margin_units_ - low) >> kSubpixelBits);  // the first centre not below
    const std::int32_t to = (high - kPixelCentre + margin_units_) >> kSubpixelBits;
    return std::max(from, first) <= std::min(to, last);
  };
  return holds(left, right, clip_.left, clip_.right - 1) && holds(top, bottom, clip_.top, clip_.bottom - 1);
}

bool PolygonModes::is_flagged(const VertexBatch& vertices, const ClippedTriangle& triangle, int k) const {
  return edge_flags_.empty() || edge_flags_[vertices.source[triangle.slot[k]]] != 0;
}

void PolygonModes::fill(const VertexBatch& vertices, const ClippedTriangle& polygon, std::span<const PolygonCorner> corners,
                        bool is_back, TriangleBatch& triangles) const {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const std::int64_t area = fan_area(vertices, corners, i);
    std::uint32_t slot[3] = {corners[0].slot, corners[i].slot, corners[i + 1].slot};
    if (area == 0 || !holds_a_centre(vertices, slot)) continue;
    if (area < 0) std::swap(slot[1], slot[2]);
    triangles.add(slot[0], slot[1], slot[2], polygon.provoking, polygon.primitive);
    triangles.is_back[static_cast<std::size_t>(triangles.count - 1)] = is_back;
  }
}

void PolygonModes::outline(const VertexBatch& vertices, const ClippedTriangle& polygon, std::span<const PolygonCorner> corners,
                           Face face, LineBatch& lines) const {
  bool begins = true;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PolygonCorner& a = corners[i];
    const PolygonCorner& b = corners[(i + 1) % corners.size()];
    // On the edge opposite vertex k both weights k are 0; what clipping cut is no edge.
    const unsigned shared = a.zero_weights & b.zero_weights;
    bool is_drawn = false;
    for (int k = 0; k < 3; ++k) is_drawn |= (shared >> k & 1u) != 0 && is_flagged(vertices, polygon, (k + 1) % 3);
    if (!is_drawn) continue;
    lines.push_back({.v0 = a.slot, .v1 = b.slot, .provoking = polygon.provoking, .primitive = polygon.primitive,
                     .is_back = face.is_back, .begins_pattern = begins, .depth_bias = face.depth_bias});
    begins = false;
  }
}

void PolygonModes::mark_corners(const VertexBatch& vertices, const ClippedTriangle& polygon,
                                std::span<const PolygonCorner> corners, Face face, PointBatch& points) const {
  for (const PolygonCorner& corner : corners)
    if (corner.vertex >= 0 && is_flagged(vertices, polygon, corner.vertex))
      points.push_back({.vertex = corner.slot, .provoking = polygon.provoking, .primitive = polygon.primitive,
                        .is_back = face.is_back, .depth_bias = face.depth_bias});
}

}  // namespace tuberia
