#include "pipeline/vertex_transform.hpp"

#include <algorithm>
#include <cstring>

#include "math/transforms.hpp"
#include "pipeline/clipping.hpp"
#include "pipeline/texture_coordinates.hpp"
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

void mark(const LineBatch& lines, std::vector<std::uint8_t>& used) {
  for (const AssembledLine& line : lines) used[line.v0] = used[line.v1] = used[line.provoking] = 1;
}

void mark(const PointBatch& points, std::vector<std::uint8_t>& used) {
  for (const AssembledPoint& point : points) used[point.vertex] = used[point.provoking] = 1;
}

UsedVertices used_vertices(const TriangleBatch& triangles, const LineBatch& lines, const PointBatch& points, const VertexBatch& batch) {
  std::vector<std::uint8_t> used(static_cast<std::size_t>(batch.size()) + 1, 0);
  mark(triangles, used);
  mark(lines, used);
  mark(points, used);
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

/// The records from slot `first` on, of vertices that clipping made.
void interpolate_clipped(VertexBatch& batch, std::size_t first) {
  const auto stride = static_cast<std::size_t>(batch.stride);
  for (std::size_t i = 0; i < batch.clipped.size(); ++i) {
    const ClippedVertex& v = batch.clipped[i];
    float* to = batch.attributes.data() + (first + batch.source.size() + i) * stride;
    for (std::size_t k = 0; k < stride; ++k) {
      double sum = 0;
      for (std::size_t j = 0; j < static_cast<std::size_t>(v.count); ++j)
        sum += v.weight[j] * static_cast<double>(batch.attributes[(first + v.slot[j]) * stride + k]);
      to[k] = static_cast<float>(sum);
    }
  }
}

/// Positions as programs see them: those of clip space as they are.
void copy_points(std::span<const glm::vec4> from, const UsedVertices& used, int pitch, float* out) {
  for (int i = 0; i < used.count; ++i)
    for (int k = 0; k < 3; ++k) out[k * pitch + i] = from[used.sources[static_cast<std::size_t>(i)]][k];
}

}  // namespace

VertexTransform::VertexTransform(const TransformState& state, const ClipLimits& limits, InstructionSet instruction_set)
    : state_(state), limits_(limits),
      clip_from_object_(compose(state.clip_from_world, state.world_from_object)),
      world_normal_from_object_(normal_matrix(state.world_from_object)),
      instruction_set_(instruction_set), kernels_(geometry_kernels(instruction_set)) {}

void VertexTransform::positions(const MeshView& mesh, VertexBatch& batch) const {
  const std::size_t count = batch.source.size(), padded = count + kKernelPadding;
  for (auto* array : {&batch.clip_x, &batch.clip_y, &batch.clip_z, &batch.clip_w}) array->resize(padded);
  batch.outcode.resize(padded);
  const auto place = [&](std::size_t slot, const glm::vec4& p, std::uint32_t code) {
    batch.clip_x[slot] = p.x, batch.clip_y[slot] = p.y, batch.clip_z[slot] = p.z, batch.clip_w[slot] = p.w;
    batch.outcode[slot] = code;
  };
  if (!mesh.screen_positions.empty()) {
    for (std::size_t slot = 0; slot < count; ++slot) place(slot, {0, 0, 0, mesh.screen_positions[batch.source[slot]].w}, 0);
    return;
  }
  if (!mesh.clip_positions.empty()) {
    for (std::size_t slot = 0; slot < count; ++slot) {
      const glm::vec4& p = mesh.clip_positions[batch.source[slot]];
      place(slot, p, outcode_of(p, limits_));
    }
    return;
  }
  batch.source.resize(padded, 0u);  // the kernel may read, but not count, beyond the end
  kernels_.transform_positions(&clip_from_object_[0][0], &mesh.positions.front().x, batch.source.data(),
                               static_cast<int>(count), limits_, batch.clip_arrays());
  batch.source.resize(count);
  for (std::size_t slot = 0; limits_.user_plane_count > 0 && slot < count; ++slot)
    batch.outcode[slot] |= user_outcode_of({batch.clip_x[slot], batch.clip_y[slot], batch.clip_z[slot], batch.clip_w[slot]}, limits_);
}

/// What lighting and programs want of the vertices in use: x, y, z arrays of `pitch` floats each.
struct VertexTransform::WorldVertices {
  UsedVertices used;
  int pitch = 0;
  AlignedVector<float> points, normals;
};

void VertexTransform::fill_in_world(const MeshView& mesh, bool with_points, bool with_normals, WorldVertices& out) const {
  const UsedVertices& used = out.used;
  out.pitch = static_cast<int>((static_cast<std::size_t>(used.count) + kKernelPadding - 1) / kKernelPadding * kKernelPadding);
  if (with_points) {
    out.points.resize(static_cast<std::size_t>(out.pitch) * 3);
    if (!mesh.clip_positions.empty()) copy_points(mesh.clip_positions, used, out.pitch, out.points.data());
    else if (!mesh.positions.empty())
      kernels_.transform_points(&state_.world_from_object[0][0], &mesh.positions.front().x, used.sources.data(), used.count, out.points.data());
  }
  if (with_normals) {
    out.normals.resize(static_cast<std::size_t>(out.pitch) * 3);
    if (!mesh.normals.empty())
      kernels_.transform_normals(&world_normal_from_object_[0][0], &mesh.normals.front().x, used.sources.data(), used.count, out.normals.data());
  }
}

/// A face's colours: the surface's own, lit by `lighting` if there is any.
void VertexTransform::fill_in_colours(const std::optional<Lighting>& lighting, std::span<const glm::vec4> surface,
                                      const WorldVertices& world, int offset, VertexBatch& batch) const {
  if (!lighting) return copy(surface, glm::vec4(1), world.used, offset, batch);
  AlignedVector<float> colours(static_cast<std::size_t>(world.pitch) * 4);
  vertex_lighting_kernel(instruction_set_)(*lighting, world.points.data(), world.normals.data(), world.pitch, colours.data());
  if (!surface.empty()) multiply(surface, world.used, world.pitch, colours.data());
  scatter(colours.data(), world.pitch, 4, world.used, offset, batch);
}

void VertexTransform::attributes(const MeshView& mesh, Attributes wanted, const TriangleBatch& triangles, VertexBatch& batch,
                                 const LineBatch& lines, const PointBatch& points) const {
  batch.stride = vertex_stride(wanted);
  const bool has_colours = contains(wanted, Attributes::colour), two_sided = state_.two_sided_colours && has_colours;
  batch.back_slots = two_sided ? batch.size() : 0;
  if (batch.stride == 0 || (triangles.count == 0 && lines.empty() && points.empty())) return;
  batch.attributes.resize(static_cast<std::size_t>(batch.size() + batch.back_slots) * static_cast<std::size_t>(batch.stride));
  const bool lit = has_colours && (state_.vertex_lighting || (two_sided && state_.back_lighting));

  WorldVertices world{used_vertices(triangles, lines, points, batch), 0, {}, {}};
  fill_in_world(mesh, contains(wanted, Attributes::position) || lit, contains(wanted, Attributes::normal) || lit, world);
  const UsedVertices& used = world.used;
  const auto offset = [&](Attributes one) { return scalar_offset(wanted, one); };
  if (contains(wanted, Attributes::position)) scatter(world.points.data(), world.pitch, 3, used, offset(Attributes::position), batch);
  if (contains(wanted, Attributes::normal)) scatter(world.normals.data(), world.pitch, 3, used, offset(Attributes::normal), batch);
  if (contains(wanted, Attributes::texcoord)) copy(mesh.texcoords, glm::vec2(0), used, offset(Attributes::texcoord), batch);
  if (contains(wanted, Attributes::custom)) copy(mesh.custom, glm::vec4(0), used, offset(Attributes::custom), batch);
  if (has_colours) fill_in_colours(state_.vertex_lighting, mesh.colours, world, offset(Attributes::colour), batch);
  write_texture_coordinates(mesh, state_, wanted, used.slots, used.sources, batch);
  interpolate_clipped(batch, 0);
  if (two_sided) add_back_faces(mesh, world, offset(Attributes::colour), batch);
}

void VertexTransform::add_back_faces(const MeshView& mesh, WorldVertices& world, int offset, VertexBatch& batch) const {
  // Their records differ in the colours alone.
  const auto back = static_cast<std::size_t>(batch.back_slots), length = back * static_cast<std::size_t>(batch.stride);
  std::copy_n(batch.attributes.begin(), length, batch.attributes.begin() + static_cast<std::ptrdiff_t>(length));
  for (std::uint32_t& slot : world.used.slots) slot += static_cast<std::uint32_t>(back);
  for (float& n : world.normals) n = -n;
  fill_in_colours(state_.back_lighting ? state_.back_lighting : state_.vertex_lighting,
                  mesh.back_colours.empty() ? mesh.colours : mesh.back_colours, world, offset, batch);
  interpolate_clipped(batch, back);
}

void VertexTransform::fog_coordinates(const MeshView& mesh, VertexBatch& batch) const {
  const auto size = static_cast<std::size_t>(batch.size()), back = static_cast<std::size_t>(batch.back_slots);
  auto& fog = batch.fog_coordinates;
  fog.assign(batch.clip_w.begin(), batch.clip_w.begin() + static_cast<std::ptrdiff_t>(size));
  if (!mesh.fog_coordinates.empty()) {
    for (std::size_t slot = 0; slot < batch.source.size(); ++slot) fog[slot] = mesh.fog_coordinates[batch.source[slot]];
    for (std::size_t i = 0; i < batch.clipped.size(); ++i) {
      const ClippedVertex& v = batch.clipped[i];
      double sum = 0;
      for (std::size_t j = 0; j < static_cast<std::size_t>(v.count); ++j) sum += v.weight[j] * static_cast<double>(fog[v.slot[j]]);
      fog[batch.source.size() + i] = static_cast<float>(sum);
    }
  }
  if (back > 0) {
    fog.resize(size + back);
    std::copy_n(fog.begin(), size, fog.begin() + static_cast<std::ptrdiff_t>(back));
  }
}

}  // namespace tuberia
