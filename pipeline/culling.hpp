#pragma once
// Stage 5: triangles that cannot show are dropped before anyone looks at their attributes.

#include "pipeline/state.hpp"
#include "pipeline/vertex_batch.hpp"

namespace tuberia {

class Culling {
 public:
  /// clip: the pixels that may be drawn; samples: of each.
  Culling(const CullingState& state, const PixelRect& clip, InstructionSet instruction_set, int samples = 1) noexcept;

  /// Drops, keeping the order: faces turned the wrong way, by the sign of the exact snapped area
  /// that coverage uses, too, so that the two cannot disagree; triangles without area; triangles
  /// whose bounds hold no pixel centre (or, with several samples, are not near one). The others come out clockwise on the screen.
  /// Of one sample a pixel, small triangles that cover no centre go, too; returns how many of them had
  /// bounds that hold one: they count as drawn.
  ///                                                                  [C 3.9, FIX 4] [rules R4]
  int operator()(const VertexBatch& vertices, TriangleBatch& triangles) const;

 private:
  CullOptions options_;
  PixelRect clip_;
  const GeometryKernels& kernels_;
};

}  // namespace tuberia
