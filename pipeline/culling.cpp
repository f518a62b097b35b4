#include "pipeline/culling.hpp"

namespace tuberia {

Culling::Culling(const CullingState& state, const PixelRect& clip, InstructionSet instruction_set, int samples) noexcept
    : clip_(clip), kernels_(geometry_kernels(instruction_set)) {
  const bool front = state.cull != CullFace::front, back = state.cull != CullFace::back;
  const bool clockwise_is_front = state.front_face == Winding::clockwise;
  options_ = {.keep_clockwise = clockwise_is_front ? front : back,
              .keep_counter_clockwise = clockwise_is_front ? back : front,
              .counter_clockwise_is_back = clockwise_is_front,
              .margin_pixels = samples > 1 ? 1 : 0};
}

int Culling::operator()(const VertexBatch& vertices, TriangleBatch& triangles) const {
  CullResult result;
  if (!clip_.empty()) result = kernels_.cull(triangles.arrays(), triangles.count, vertices.screen.data(), options_, clip_);
  triangles.resize(result.kept);
  return result.uncovered;
}

}  // namespace tuberia
