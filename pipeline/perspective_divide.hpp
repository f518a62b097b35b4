#pragma once
// Stage 4: clip space to ndc by division, to the screen by the viewport, to 24.8 by the snap.

#include <span>

#include "pipeline/draw_call.hpp"
#include "pipeline/vertex_batch.hpp"

namespace tuberia {

/// The affine maps of a viewport and a depth range, y flipped since row 0 is at the top.  [C 3.5]
/// Places are rounded to 2^-subpixel_bits pixels (0..8).
ScreenMap screen_map(const Viewport& viewport, const DepthRange& range, ClipVolume volume, int subpixel_bits = kSubpixelBits) noexcept;

class PerspectiveDivide {
 public:
  PerspectiveDivide(const ScreenMap& map, InstructionSet instruction_set) noexcept
      : map_(map), kernels_(geometry_kernels(instruction_set)) {}

  /// Screen coordinates and depths of all vertices of the batch. Clip w stays: interpolation needs
  /// it.                                                            [C 3.8] [rules R1]
  void operator()(VertexBatch& batch) const;

  /// In its place, for vertices that are on the screen already.
  static void take(std::span<const ScreenVertex> vertices, VertexBatch& batch);

 private:
  ScreenMap map_;
  const GeometryKernels& kernels_;
};

}  // namespace tuberia
