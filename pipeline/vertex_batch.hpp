#pragma once
// The batches that travel through the geometry stages: the vertices and triangles of one chunk.

#include <cstdint>
#include <vector>

#include "base/aligned_vector.hpp"
#include "raster/geometry_kernels.hpp"

namespace tuberia {

/// A vertex that clipping made: weights of the three vertices of the triangle it lies on.
struct ClippedVertex {
  std::uint32_t slot[3];
  double weight[3];  // their sum is 1; linear in clip space
};

/// Vertices, an array for each coordinate. A vertex's number here is its slot. Slots from
/// source.size() on were made by clipping; slot source.size() + i by clipped[i].
struct VertexBatch {
  std::vector<std::uint32_t> source;        // number in the mesh
  std::vector<ClippedVertex> clipped;
  AlignedVector<float> clip_x, clip_y, clip_z, clip_w;      // clip space
  AlignedVector<std::uint32_t> outcode;
  AlignedVector<std::int32_t> screen_x, screen_y;           // 24.8 units
  AlignedVector<float> depth;
  AlignedVector<float> attributes;          // `stride` floats a slot; only of vertices in use
  int stride = 0;
  AlignedVector<float> fog_coordinates;     // one a slot; empty without fog

  int size() const noexcept { return static_cast<int>(source.size() + clipped.size()); }
  ClipArrays clip_arrays() noexcept {
    return {clip_x.data(), clip_y.data(), clip_z.data(), clip_w.data(), outcode.data()};
  }
  ScreenArrays screen_arrays() noexcept { return {screen_x.data(), screen_y.data(), depth.data()}; }
};

/// Triangles as slots of a VertexBatch.
struct TriangleBatch {
  std::vector<std::uint32_t> v0, v1, v2;
  std::vector<std::uint32_t> provoking;   // the vertex that gives flat attributes
  std::vector<std::uint32_t> primitive;   // number in the draw
  int count = 0;                          // the arrays are padded beyond it for the kernels

  void clear() { resize(0); }
  /// Keeps the padding filled with valid slots.
  void resize(int new_count) {
    count = new_count;
    const std::size_t padded = static_cast<std::size_t>(new_count) + kKernelPadding;
    for (auto* array : {&v0, &v1, &v2, &provoking, &primitive}) array->resize(padded, 0u);
  }
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t first, std::uint32_t number) {
    const auto i = static_cast<std::size_t>(count);
    resize(count + 1);
    v0[i] = a;
    v1[i] = b;
    v2[i] = c;
    provoking[i] = first;
    primitive[i] = number;
  }
  TriangleArrays arrays() noexcept { return {v0.data(), v1.data(), v2.data(), provoking.data(), primitive.data()}; }
};

}  // namespace tuberia
