#include "pipeline/vertex_transform.hpp"

#include <algorithm>
#include <cstring>

#include "math/transforms.hpp"
#include "pipeline/vertex_lighting.hpp"

namespace tuberia {
namespace {

/// Original vertices in use, by slot, and their numbers in the mesh; padded for the kernels.
struct UsedVertices {
  std::vector<std::uint32_t> slots, sources;
  int count = 0;
};

void mark(const TriangleBatch& triangles, std::vector<std::uint8_t>& used) {
  const auto count = static_cast<std::size_t>(triangles.count);
  for (std::size_t i = 0; i < count; ++i)
    used[triangles.v0[i]] = used[triangles.v1[i]] = used[triangles.v2[i]] = used[triangles.provoking[i]] = 1;
}

UsedVertices used_vertices(const TriangleBatch& triangles, const VertexBatch& batch) {
  std::vector<std::uint8_t> used(static_cast<std::size_t>(batch.size()) + 1, 0);
  mark(triangles, used);
  // A clipped vertex needs the three that it was made from.
  for (std::size_t i = 0; i < batch.clipped.size(); ++i)
    if (used[batch.source.size() + i] != 0)
      for (const std::uint32_t slot : batch.clipped[i].slot) used[slot] = 1;

  UsedVertices result;
  for (std::size_t slot = 0; slot < batch.source.size(); ++slot)
    if (used[slot] != 0) {
      result.slots.push_back(static_cast<std::uint32_t>(slot));
      result.sources.push_back(batch.source[slot]);
    }
  result.count = static_cast<int>(result.slots.size());
  result.sources.resize(result.slots.size() + kKernelPadding, 0u);
  return result;
}

/// Copies arrays of one scalar each (x, y, z, ... `pitch` apart) to the vertices' records.
void scatter(const float* arrays, int pitch, int scalars, const UsedVertices& used, int offset, VertexBatch& batch) {
  for (int i = 0; i < used.count; ++i) {
    float* record = batch.attributes.data() + static_cast<std::size_t>(used.slots[static_cast<std::size_t>(i)]) * static_cast<std::size_t>(batch.stride) + offset;
    for (int k = 0; k < scalars; ++k) record[k] = arrays[k * pitch + i];
  }
}

/// Copies an attribute that needs no transformation.
template <class Vector>
void copy(std::span<const Vector> from, const Vector& missing, const UsedVertices& used, int offset, VertexBatch& batch) {
  for (std::size_t i = 0; i < used.slots.size(); ++i) {
    const Vector& value = from.empty() ? missing : from[used.sources[i]];
    std::memcpy(batch.attributes.data() + used.slots[i] * static_cast<std::size_t>(batch.stride) + offset, &value, sizeof value);
  }
}

/// Light times the surface's own colours.
void multiply(std::span<const glm::vec4> surface, const UsedVertices& used, int pitch, float* light) {
  for (int i = 0; i < used.count; ++i)
    for (int k = 0; k < 4; ++k) light[k * pitch + i] *= surface[used.sources[static_cast<std::size_t>(i)]][k];
}

void interpolate_clipped(VertexBatch& batch) {
  const auto stride = static_cast<std::size_t>(batch.stride);
  for (std::size_t i = 0; i < batch.clipped.size(); ++i) {
    const ClippedVertex& v = batch.clipped[i];
    float* to = batch.attributes.data() + (batch.source.size() + i) * stride;
    for (std::size_t k = 0; k < stride; ++k) {
      double sum = 0;
      for (std::size_t j = 0; j < 3; ++j)
        sum += v.weight[j] * static_cast<double>(batch.attributes[v.slot[j] * stride + k]);
      to[k] = static_cast<float>(sum);
    }
  }
}

}  // namespace

VertexTransform::VertexTransform(const TransformState& state, const ClipLimits& limits, InstructionSet instruction_set)
    : state_(state), limits_(limits),
      clip_from_object_(compose(state.clip_from_world, state.world_from_object)),
      world_normal_from_object_(normal_matrix(state.world_from_object)),
      instruction_set_(instruction_set), kernels_(geometry_kernels(instruction_set)) {}

void VertexTransform::positions(const MeshView& mesh, VertexBatch& batch) const {
  const std::size_t padded = batch.source.size() + kKernelPadding;
  for (auto* array : {&batch.clip_x, &batch.clip_y, &batch.clip_z, &batch.clip_w}) array->resize(padded);
  batch.outcode.resize(padded);
  batch.source.resize(padded, 0u);  // the kernel may read, but not count, beyond the end
  kernels_.transform_positions(&clip_from_object_[0][0], &mesh.positions.front().x, batch.source.data(),
                               static_cast<int>(padded - kKernelPadding), limits_, batch.clip_arrays());
  batch.source.resize(padded - kKernelPadding);
}

void VertexTransform::attributes(const MeshView& mesh, Attributes wanted, const TriangleBatch& triangles,
                                 VertexBatch& batch) const {
  batch.stride = vertex_stride(wanted);
  if (batch.stride == 0 || triangles.count == 0) return;
  batch.attributes.resize(static_cast<std::size_t>(batch.size()) * static_cast<std::size_t>(batch.stride));
  const UsedVertices used = used_vertices(triangles, batch);
  const int pitch = static_cast<int>((static_cast<std::size_t>(used.count) + kKernelPadding - 1) / kKernelPadding * kKernelPadding);
  const bool lit = state_.vertex_lighting.has_value() && contains(wanted, Attributes::colour);

  AlignedVector<float> points, normals;
  const auto offset = [&](Attributes one) { return scalar_offset(wanted, one); };
  if (contains(wanted, Attributes::position) || lit) {
    points.resize(static_cast<std::size_t>(pitch) * 3);
    kernels_.transform_points(&state_.world_from_object[0][0], &mesh.positions.front().x, used.sources.data(), used.count, points.data());
  }
  if (contains(wanted, Attributes::normal) || lit) {
    normals.resize(static_cast<std::size_t>(pitch) * 3);
    if (!mesh.normals.empty())
      kernels_.transform_normals(&world_normal_from_object_[0][0], &mesh.normals.front().x, used.sources.data(), used.count, normals.data());
  }
  if (contains(wanted, Attributes::position)) scatter(points.data(), pitch, 3, used, offset(Attributes::position), batch);
  if (contains(wanted, Attributes::normal)) scatter(normals.data(), pitch, 3, used, offset(Attributes::normal), batch);
  if (contains(wanted, Attributes::texcoord)) copy(mesh.texcoords, glm::vec2(0), used, offset(Attributes::texcoord), batch);
  if (contains(wanted, Attributes::custom)) copy(mesh.custom, glm::vec4(0), used, offset(Attributes::custom), batch);
  if (lit) {
    AlignedVector<float> colours(static_cast<std::size_t>(pitch) * 4);
    vertex_lighting_kernel(instruction_set_)(*state_.vertex_lighting, points.data(), normals.data(), pitch, colours.data());
    if (!mesh.colours.empty()) multiply(mesh.colours, used, pitch, colours.data());
    scatter(colours.data(), pitch, 4, used, offset(Attributes::colour), batch);
  } else if (contains(wanted, Attributes::colour)) {
    copy(mesh.colours, glm::vec4(1), used, offset(Attributes::colour), batch);
  }
  interpolate_clipped(batch);
}

}  // namespace tuberia
