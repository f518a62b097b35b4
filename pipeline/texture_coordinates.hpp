#pragma once
// The texture coordinates (s, t, r, q) of the texture units, a vertex at a time: taken from the mesh or
// generated from positions and normals, then transformed.              docs/machine.md, "Texture coordinates"

#include <cstdint>
#include <optional>
#include <span>

#include "base/result.hpp"
#include "pipeline/draw_call.hpp"
#include "pipeline/vertex_batch.hpp"

namespace tuberia {

/// Why the units that `wanted` names cannot have their coordinates: nothing to take or make them from, a map that cannot give that coordinate, planes or matrices
/// that are not finite, normals or object positions that the mesh lacks.
std::optional<Error> check_texture_coordinates(const MeshView& mesh, const TransformState& state, Attributes wanted);

/// Writes the coordinates of the units that `wanted` names into the records of the vertices at these
/// slots; sources[i] is the number in the mesh of the vertex at slots[i].
void write_texture_coordinates(const MeshView& mesh, const TransformState& state, Attributes wanted,
                               std::span<const std::uint32_t> slots, std::span<const std::uint32_t> sources, VertexBatch& batch);

}  // namespace tuberia
