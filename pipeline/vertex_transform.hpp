#pragma once
// Stage 1: object space to clip space; attributes follow later, for the vertices still needed.

#include <optional>
#include <span>

#include "pipeline/draw_call.hpp"
#include "pipeline/vertex_batch.hpp"
#include "raster/geometry_kernels.hpp"

namespace tuberia {

class VertexTransform {
 public:
  VertexTransform(const TransformState& state, const ClipLimits& limits, InstructionSet instruction_set);

  /// Clip positions and outcodes of batch.source.                                     [C 3.1]
  /// Meshes in clip space are copied; of those on the screen only w is, and none is outside.
  void positions(const MeshView& mesh, VertexBatch& batch) const;

  /// The attributes in `wanted` of the vertices that the primitives use: positions and normals to
  /// world space, tangents, too, without being made unit, colours lit (and multiplied with the mesh's) when the state says so, the rest as it is; those that clipping made
  /// are interpolated from theirs. An attribute the mesh lacks is white, for a colour, or 0. With two-sided
  /// colours there are records for the back faces, too, batch.back_slots further on.
  void attributes(const MeshView& mesh, Attributes wanted, const TriangleBatch& triangles, VertexBatch& batch,
                  const LineBatch& lines = {}, const PointBatch& points = {}) const;

  /// The mesh's fog coordinates, interpolated where clipping made vertices; or every vertex's clip w.
  void fog_coordinates(const MeshView& mesh, VertexBatch& batch) const;

  /// In their place the shares of colour that the fog leaves at the vertices, interpolated where clipping
  /// made some.
  void fog_shares(const MeshView& mesh, const FogState& fog, VertexBatch& batch) const;

 private:
  void fill_in_world(const MeshView& mesh, bool with_points, bool with_normals, WorldVertices& out) const;
  void fill_in_colours(const std::optional<Lighting>& lighting, std::span<const glm::vec4> surface, int offset,
                       VertexBatch& batch) const;
  void fill_in_cosines(int offset, VertexBatch& batch) const;
  void turn_tangents(std::span<const glm::vec3> tangents, int offset, VertexBatch& batch) const;
  void add_back_faces(const MeshView& mesh, int offset, VertexBatch& batch) const;

  TransformState state_;
  ClipLimits limits_;
  glm::mat4 clip_from_object_;
  glm::mat3 world_normal_from_object_;
  InstructionSet instruction_set_;
  const GeometryKernels& kernels_;
};

}  // namespace tuberia
