#pragma once
// The batches that travel through the geometry stages: the vertices and primitives of one chunk.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/aligned_vector.hpp"
#include "raster/geometry_kernels.hpp"

namespace tuberia {

/// A vertex that clipping made: weights of the vertices of the triangle or line that it lies on.
struct ClippedVertex {
  std::uint32_t slot[3];
  double weight[3];  // their sum is 1; linear in clip space
  int count = 3;     // 2 on a line
};

/// What attributes are made from: the vertices of the mesh in use, and x, y, z (and for colours a
/// fourth) arrays of `pitch` floats each. Kept from chunk to chunk for its memory.
struct WorldVertices {
  std::vector<std::uint8_t> is_used;               // by slot
  std::vector<std::uint32_t> slots, sources;       // of those in use; sources are numbers in the mesh
  int count = 0, pitch = 0;
  AlignedVector<float> points, normals, tangents, colours;
};

/// Vertices, an array for each coordinate. A vertex's number here is its slot. Slots from
/// source.size() on were made by clipping; slot source.size() + i by clipped[i]. The other arrays may be
/// longer than there are vertices.
struct VertexBatch {
  std::vector<std::uint32_t> source;        // number in the mesh
  std::vector<ClippedVertex> clipped;
  AlignedVector<float> clip_x, clip_y, clip_z, clip_w;      // clip space
  AlignedVector<std::uint32_t> outcode;
  AlignedVector<ScreenVertex> screen;       // after the perspective divide
  AlignedVector<float> attributes;          // `stride` floats a slot; only of vertices in use
  int stride = 0;
  AlignedVector<float> fog_coordinates;     // one a slot; empty without fog
  // Where faces have colours of their own, the vertices of those that are turned away are stored so
  // many slots after the vertices themselves; else 0.
  int back_slots = 0;
  WorldVertices world;

  int size() const noexcept { return static_cast<int>(source.size() + clipped.size()); }
  ClipArrays clip_arrays() noexcept {
    return {clip_x.data(), clip_y.data(), clip_z.data(), clip_w.data(), outcode.data()};
  }
};

/// Triangles as slots of a VertexBatch.
struct TriangleBatch {
  std::vector<std::uint32_t> v0, v1, v2;
  std::vector<std::uint32_t> provoking;   // the vertex that gives flat attributes
  std::vector<std::uint32_t> primitive;   // number in the draw
  std::vector<std::uint8_t> is_back;      // turned away; after culling
  int count = 0;                          // the arrays go on beyond it, for the kernels with valid slots

  void clear() { resize(0); }
  void resize(int new_count) {
    count = new_count;
    const auto end = static_cast<std::size_t>(new_count);
    for (auto* array : {&v0, &v1, &v2, &provoking, &primitive}) {
      make_room(*array, end + kKernelPadding);
      std::fill_n(array->begin() + new_count, kKernelPadding, 0u);
    }
    make_room(is_back, end + kKernelPadding);
  }
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t first, std::uint32_t number) {
    const auto i = static_cast<std::size_t>(count);
    if (v0.size() < i + 1 + kKernelPadding) resize(2 * count + 64);  // seldom: there are six arrays to grow
    count = static_cast<int>(i) + 1;
    v0[i + kKernelPadding] = v1[i + kKernelPadding] = v2[i + kKernelPadding] = 0;
    v0[i] = a;
    v1[i] = b;
    v2[i] = c;
    provoking[i] = first;
    primitive[i] = number;
  }
  TriangleArrays arrays() noexcept { return {v0.data(), v1.data(), v2.data(), provoking.data(), primitive.data(), is_back.data()}; }
};

/// A line as slots of a VertexBatch: one of a list, a strip or a loop, or a polygon's edge.
struct AssembledLine {
  std::uint32_t v0 = 0, v1 = 0;
  std::uint32_t provoking = 0, primitive = 0;  // as for triangles
  bool is_back = false;          // of a polygon that is turned away
  bool begins_pattern = true;    // the stipple pattern starts here; else it goes on from the line before
  double depth_bias = 0;         // of the polygon
};

struct AssembledPoint {
  std::uint32_t vertex = 0;
  std::uint32_t provoking = 0, primitive = 0;
  bool is_back = false;
  double depth_bias = 0;
};

using LineBatch = std::vector<AssembledLine>;
using PointBatch = std::vector<AssembledPoint>;

/// A triangle that was clipped, whole: what polygon modes look at.
struct ClippedTriangle {
  std::uint32_t slot[3];               // of the triangle's own vertices
  std::uint32_t provoking, primitive;
  std::uint32_t first_corner, corner_count;
};

/// One corner of it.
struct PolygonCorner {
  std::uint32_t slot;
  std::uint8_t zero_weights;           // bit k: the weight of vertex k is exactly 0
  std::int8_t vertex;                  // 0..2 for the triangle's own vertices, else -1
};

struct PolygonBatch {
  std::vector<ClippedTriangle> polygons;
  std::vector<PolygonCorner> corners;
  void clear() {
    polygons.clear();
    corners.clear();
  }
};

}  // namespace tuberia
