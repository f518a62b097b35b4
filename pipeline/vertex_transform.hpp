#pragma once
// Stage 1: object space to clip space; attributes follow later, for the vertices still needed.

#include "pipeline/draw_call.hpp"
#include "pipeline/vertex_batch.hpp"
#include "raster/geometry_kernels.hpp"

namespace tuberia {

class VertexTransform {
 public:
  VertexTransform(const TransformState& state, const ClipLimits& limits, InstructionSet instruction_set);

  /// Clip positions and outcodes of batch.source.                                     [C 3.1]
  void positions(const MeshView& mesh, VertexBatch& batch) const;

  /// The attributes in `wanted` of the vertices that `triangles` use: positions and normals to
  /// world space, colours lit (and multiplied with the mesh's) when the state says so, the rest as it is; those that clipping made
  /// are interpolated from theirs. An attribute the mesh lacks is white, for a colour, or 0.
  void attributes(const MeshView& mesh, Attributes wanted, const TriangleBatch& triangles, VertexBatch& batch) const;

 private:
  TransformState state_;
  ClipLimits limits_;
  glm::mat4 clip_from_object_;
  glm::mat3 world_normal_from_object_;
  InstructionSet instruction_set_;
  const GeometryKernels& kernels_;
};

}  // namespace tuberia
