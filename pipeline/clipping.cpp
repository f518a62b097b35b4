#include "pipeline/clipping.hpp"

#include <algorithm>
#include <tuple>

namespace tuberia {
namespace {

std::array<double, 4> position_of(const VertexBatch& vertices, std::uint32_t slot) {
  return {static_cast<double>(vertices.clip_x[slot]), static_cast<double>(vertices.clip_y[slot]),
          static_cast<double>(vertices.clip_z[slot]), static_cast<double>(vertices.clip_w[slot])};
}

/// Which of the primitive's own vertices a corner is; -1 for none. (A share of 1 alone does not make
/// it one: it may have been rounded, and little of a far vertex is much.)
int own_vertex(const ClippedCorner& corner) {
  const auto whole = std::find(corner.weight, corner.weight + 3, 1.0);
  return whole != corner.weight + 3 && std::count(corner.weight, corner.weight + 3, 0.0) == 2 ? static_cast<int>(whole - corner.weight) : -1;
}

/// The slot of a corner: one that was a vertex keeps its slot, and with it every bit of its place.
std::uint32_t slot_of(const ClippedCorner& corner, std::span<const std::uint32_t> slot, VertexBatch& vertices) {
  if (const int own = own_vertex(corner); own >= 0) return slot[static_cast<std::size_t>(own)];
  const auto number = static_cast<std::size_t>(vertices.size());
  vertices.clipped.push_back({{slot.front(), slot[1], slot.back()}, {corner.weight[0], corner.weight[1], corner.weight[2]},
                              static_cast<int>(slot.size())});
  const std::size_t padded = number + 1 + kKernelPadding;
  AlignedVector<float>* arrays[4] = {&vertices.clip_x, &vertices.clip_y, &vertices.clip_z, &vertices.clip_w};
  for (std::size_t k = 0; k < 4; ++k) {
    make_room(*arrays[k], padded);
    (*arrays[k])[number] = static_cast<float>(corner.position[k]);
  }
  return static_cast<std::uint32_t>(number);
}

/// Adds a polygon's fan, and to `polygons`, if there are any, the polygon itself.
void add_polygon(const ClippedPolygon& polygon, const ClippedTriangle& triangle, VertexBatch& vertices, TriangleBatch& out,
                 PolygonBatch* polygons) {
  if (polygon.count == 0) return;
  std::array<std::uint32_t, std::tuple_size_v<decltype(polygon.corner)>> corner_slot{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i)
    corner_slot[i] = slot_of(polygon.corner[i], triangle.slot, vertices);
  for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(polygon.count); ++i)
    out.add(corner_slot[0], corner_slot[i], corner_slot[i + 1], triangle.provoking, triangle.primitive);
  if (polygons == nullptr) return;

  ClippedTriangle& added = polygons->polygons.emplace_back(triangle);
  added.first_corner = static_cast<std::uint32_t>(polygons->corners.size());
  added.corner_count = static_cast<std::uint32_t>(polygon.count);
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i) {
    const ClippedCorner& corner = polygon.corner[i];
    unsigned zero = 0;
    for (unsigned k = 0; k < 3; ++k) zero |= corner.weight[k] == 0 ? 1u << k : 0u;
    polygons->corners.push_back({corner_slot[i], static_cast<std::uint8_t>(zero), static_cast<std::int8_t>(own_vertex(corner))});
  }
}

void add_whole(const ClippedTriangle& triangle, TriangleBatch& out, PolygonBatch* polygons) {
  out.add(triangle.slot[0], triangle.slot[1], triangle.slot[2], triangle.provoking, triangle.primitive);
  if (polygons == nullptr) return;
  ClippedTriangle& added = polygons->polygons.emplace_back(triangle);
  added.first_corner = static_cast<std::uint32_t>(polygons->corners.size());
  added.corner_count = 3;
  for (int k = 0; k < 3; ++k)
    polygons->corners.push_back({triangle.slot[k], static_cast<std::uint8_t>(7 ^ 1 << k), static_cast<std::int8_t>(k)});
}

}  // namespace

int Clipping::operator()(VertexBatch& vertices, TriangleBatch& triangles) const { return clip_all(vertices, triangles, nullptr); }

int Clipping::operator()(VertexBatch& vertices, TriangleBatch& triangles, PolygonBatch& polygons) const {
  polygons.clear();
  return clip_all(vertices, triangles, &polygons);
}

int Clipping::clip_all(VertexBatch& vertices, TriangleBatch& triangles, PolygonBatch* polygons) const {
  // Most chunks lie wholly inside.
  std::uint32_t any = 0;
  for (std::size_t i = 0; i < vertices.source.size(); ++i) any |= vertices.outcode[i];
  if (any == 0 && polygons == nullptr) return 0;

  TriangleBatch out;
  int cut_count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(triangles.count); ++i) {
    const ClippedTriangle triangle{{triangles.v0[i], triangles.v1[i], triangles.v2[i]}, triangles.provoking[i], triangles.primitive[i], 0, 0};
    const std::uint32_t a = vertices.outcode[triangle.slot[0]], b = vertices.outcode[triangle.slot[1]], c = vertices.outcode[triangle.slot[2]];
    const std::uint32_t crossed = a | b | c;
    if (crossed == 0) {
      add_whole(triangle, out, polygons);
      continue;
    }
    if ((crossed & outcode::invalid) != 0 || (a & b & c) != 0) continue;

    std::array<std::array<double, 4>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = position_of(vertices, triangle.slot[k]);
    add_polygon(clip_triangle(corners, crossed, limits_), triangle, vertices, out, polygons);
    ++cut_count;
  }
  triangles = std::move(out);
  return cut_count;
}

int Clipping::operator()(VertexBatch& vertices, LineBatch& lines) const {
  int cut_count = 0;
  std::size_t kept = 0;
  for (AssembledLine line : lines) {
    const std::uint32_t a = vertices.outcode[line.v0], b = vertices.outcode[line.v1], crossed = a | b;
    if ((crossed & outcode::invalid) != 0 || (a & b) != 0) continue;
    if (crossed != 0) {
      ++cut_count;
      const std::array<std::uint32_t, 2> slot{line.v0, line.v1};
      const std::array<std::array<double, 4>, 2> ends{position_of(vertices, slot[0]), position_of(vertices, slot[1])};
      const ClippedLine rest = clip_line(ends, crossed, limits_);
      if (rest.is_empty) continue;
      line.v0 = slot_of(rest.corner[0], slot, vertices);
      line.v1 = slot_of(rest.corner[1], slot, vertices);
    }
    lines[kept++] = line;
  }
  lines.resize(kept);
  return cut_count;
}

int Clipping::operator()(const VertexBatch& vertices, PointBatch& points) const {
  std::erase_if(points, [&](const AssembledPoint& point) { return vertices.outcode[point.vertex] != 0; });
  return 0;
}

}  // namespace tuberia
