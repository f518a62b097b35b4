#pragma once
// Batches as the geometry stages pass them on, made by hand.

#include <span>
#include <vector>

#include "pipeline/vertex_batch.hpp"
#include "tests/support/every_instruction_set.hpp"

namespace tuberia::test {

/// Clip-space vertices, in slots 0, 1, 2, ...; all of them inside.
inline VertexBatch clip_batch(std::span<const std::array<float, 4>> corners) {
  VertexBatch batch;
  const std::size_t padded = corners.size() + kKernelPadding;
  AlignedVector<float>* arrays[4] = {&batch.clip_x, &batch.clip_y, &batch.clip_z, &batch.clip_w};
  for (std::size_t axis = 0; axis < 4; ++axis) {
    arrays[axis]->resize(padded);
    for (std::size_t i = 0; i < corners.size(); ++i) (*arrays[axis])[i] = corners[i][axis];
  }
  batch.outcode.resize(padded);
  for (std::size_t i = 0; i < corners.size(); ++i) batch.source.push_back(static_cast<std::uint32_t>(i));
  return batch;
}

/// Screen-space vertices in 24.8 units.
inline VertexBatch screen_batch(std::span<const std::array<std::int32_t, 2>> points) {
  VertexBatch batch;
  const std::size_t padded = points.size() + kKernelPadding;
  batch.screen.resize(padded);
  batch.clip_w.resize(padded, 1.0f);
  for (std::size_t i = 0; i < points.size(); ++i) {
    batch.screen[i].x = points[i][0];
    batch.screen[i].y = points[i][1];
    batch.source.push_back(static_cast<std::uint32_t>(i));
  }
  return batch;
}

}  // namespace tuberia::test
