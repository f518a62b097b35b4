#include "pipeline/vertex_transform.hpp"

#include <algorithm>
#include <cstring>

#include "math/transforms.hpp"
#include "pipeline/clipping.hpp"
#include "pipeline/texture_coordinates.hpp"
#include "pipeline/vertex_lighting.hpp"

namespace tuberia {
namespace {

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

/// Finds the original vertices in use; the lists are padded for the kernels.
void list_used(const TriangleBatch& triangles, const LineBatch& lines, const PointBatch& points, VertexBatch& batch) {
  WorldVertices& world = batch.world;
  const std::size_t originals = batch.source.size();
  world.is_used.assign(static_cast<std::size_t>(batch.size()), 0);
  mark(triangles, world.is_used);
  mark(lines, world.is_used);
  mark(points, world.is_used);
  // A clipped vertex needs the three that it was made from.
  for (std::size_t i = 0; i < batch.clipped.size(); ++i)
    if (world.is_used[originals + i] != 0)
      for (const std::uint32_t slot : batch.clipped[i].slot) world.is_used[slot] = 1;

  make_room(world.slots, originals + kKernelPadding);
  make_room(world.sources, originals + kKernelPadding);
  std::size_t count = 0;
  for (std::size_t slot = 0; slot < originals; ++slot) {
    world.slots[count] = static_cast<std::uint32_t>(slot);
    world.sources[count] = batch.source[slot];
    count += world.is_used[slot];
  }
  std::fill_n(world.sources.begin() + static_cast<std::ptrdiff_t>(count), kKernelPadding, 0u);
  world.count = static_cast<int>(count);
  world.pitch = static_cast<int>((count + kKernelPadding - 1) / kKernelPadding * kKernelPadding);
}

/// Copies arrays of one scalar each (x, y, z, ... `pitch` apart) to the vertices' records.
void scatter(const float* arrays, int scalars, int offset, VertexBatch& batch) {
  const WorldVertices& world = batch.world;
  for (int i = 0; i < world.count; ++i) {
    float* record = batch.attributes.data() + static_cast<std::size_t>(world.slots[static_cast<std::size_t>(i)]) * static_cast<std::size_t>(batch.stride) + offset;
    for (int k = 0; k < scalars; ++k) record[k] = arrays[k * world.pitch + i];
  }
}

/// Copies an attribute that needs no transformation.
template <class Vector>
void copy(std::span<const Vector> from, const Vector& missing, int offset, VertexBatch& batch) {
  const WorldVertices& world = batch.world;
  float* const records = batch.attributes.data() + offset;
  const auto stride = static_cast<std::size_t>(batch.stride);
  for (std::size_t i = 0; i < static_cast<std::size_t>(world.count); ++i) {
    const Vector& value = from.empty() ? missing : from[world.sources[i]];
    std::memcpy(records + world.slots[i] * stride, &value, sizeof value);
  }
}

/// Light times the surface's own colours.
void multiply(std::span<const glm::vec4> surface, WorldVertices& world) {
  for (int i = 0; i < world.count; ++i)
    for (int k = 0; k < 4; ++k)
      world.colours[static_cast<std::size_t>(k * world.pitch + i)] *= surface[world.sources[static_cast<std::size_t>(i)]][k];
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
void copy_points(std::span<const glm::vec4> from, WorldVertices& world) {
  for (int i = 0; i < world.count; ++i)
    for (int k = 0; k < 3; ++k)
      world.points[static_cast<std::size_t>(k * world.pitch + i)] = from[world.sources[static_cast<std::size_t>(i)]][k];
}

Triples triples(std::span<const glm::vec3> vectors) { return {&vectors.front().x, vectors.size()}; }

/// Every vertex's clip w, or of the mesh's own vertices what the mesh says.
void take_fog_coordinates(const MeshView& mesh, VertexBatch& batch) {
  auto& fog = batch.fog_coordinates;
  fog.assign(batch.clip_w.begin(), batch.clip_w.begin() + batch.size());
  if (mesh.fog_coordinates.empty()) return;
  for (std::size_t slot = 0; slot < batch.source.size(); ++slot) fog[slot] = mesh.fog_coordinates[batch.source[slot]];
}

/// What fog has at the vertices that clipping made: the weighted sum.
void interpolate_clipped_fog(VertexBatch& batch) {
  auto& fog = batch.fog_coordinates;
  for (std::size_t i = 0; i < batch.clipped.size(); ++i) {
    const ClippedVertex& v = batch.clipped[i];
    double sum = 0;
    for (std::size_t j = 0; j < static_cast<std::size_t>(v.count); ++j) sum += v.weight[j] * static_cast<double>(fog[v.slot[j]]);
    fog[batch.source.size() + i] = static_cast<float>(sum);
  }
}

void copy_fog_to_back_faces(VertexBatch& batch) {
  if (batch.back_slots == 0) return;
  const auto size = static_cast<std::size_t>(batch.size()), back = static_cast<std::size_t>(batch.back_slots);
  batch.fog_coordinates.resize(size + back);
  std::copy_n(batch.fog_coordinates.begin(), size, batch.fog_coordinates.begin() + static_cast<std::ptrdiff_t>(back));
}

}  // namespace

VertexTransform::VertexTransform(const TransformState& state, const ClipLimits& limits, InstructionSet instruction_set)
    : state_(state), limits_(limits),
      clip_from_object_(compose(state.clip_from_world, state.world_from_object)),
      world_normal_from_object_(normal_matrix(state.world_from_object)),
      instruction_set_(instruction_set), kernels_(geometry_kernels(instruction_set)) {}

void VertexTransform::positions(const MeshView& mesh, VertexBatch& batch) const {
  const std::size_t count = batch.source.size(), padded = count + kKernelPadding;
  for (auto* array : {&batch.clip_x, &batch.clip_y, &batch.clip_z, &batch.clip_w}) make_room(*array, padded);
  make_room(batch.outcode, padded);
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
  kernels_.transform_positions(&clip_from_object_[0][0], triples(mesh.positions), batch.source.data(),
                               static_cast<int>(count), limits_, batch.clip_arrays());
  batch.source.resize(count);
  for (std::size_t slot = 0; limits_.user_plane_count > 0 && slot < count; ++slot)
    batch.outcode[slot] |= user_outcode_of({batch.clip_x[slot], batch.clip_y[slot], batch.clip_z[slot], batch.clip_w[slot]}, limits_);
}

void VertexTransform::fill_in_world(const MeshView& mesh, bool with_points, bool with_normals, WorldVertices& out) const {
  const auto room = static_cast<std::size_t>(out.pitch) * 3;
  if (with_points) {
    make_room(out.points, room);
    if (!mesh.clip_positions.empty()) copy_points(mesh.clip_positions, out);
    else if (!mesh.positions.empty())
      kernels_.transform_points(&state_.world_from_object[0][0], triples(mesh.positions), out.sources.data(), out.count, out.points.data());
    else std::fill_n(out.points.begin(), room, 0.0f);
  }
  if (with_normals) {
    make_room(out.normals, room);
    if (!mesh.normals.empty())
      kernels_.transform_normals(&world_normal_from_object_[0][0], triples(mesh.normals), out.sources.data(), out.count, out.normals.data());
    else std::fill_n(out.normals.begin(), room, 0.0f);
  }
}

void VertexTransform::turn_tangents(std::span<const glm::vec3> tangents, int offset, VertexBatch& batch) const {
  if (tangents.empty()) return copy(tangents, glm::vec3(0), offset, batch);
  WorldVertices& world = batch.world;
  make_room(world.tangents, static_cast<std::size_t>(world.pitch) * 3);
  glm::mat4 linear = state_.world_from_object;  // its part that turns directions
  linear[3] = {0, 0, 0, 1};
  kernels_.transform_points(&linear[0][0], triples(tangents), world.sources.data(), world.count, world.tangents.data());
  scatter(world.tangents.data(), 3, offset, batch);
}

/// A face's colours: the surface's own, lit by `lighting` if there is any.
void VertexTransform::fill_in_colours(const std::optional<Lighting>& lighting, std::span<const glm::vec4> surface,
                                      int offset, VertexBatch& batch) const {
  if (!lighting) return copy(surface, glm::vec4(1), offset, batch);
  WorldVertices& world = batch.world;
  make_room(world.colours, static_cast<std::size_t>(world.pitch) * 4);
  vertex_lighting_kernel(instruction_set_)(*lighting, world.points.data(), world.normals.data(), world.pitch, world.colours.data());
  if (!surface.empty()) multiply(surface, world);
  scatter(world.colours.data(), 4, offset, batch);
}

void VertexTransform::fill_in_cosines(int offset, VertexBatch& batch) const {
  WorldVertices& world = batch.world;
  make_room(world.colours, static_cast<std::size_t>(world.pitch) * 4);
  vertex_cosines_kernel(instruction_set_)(*state_.vertex_cosines, world.points.data(), world.normals.data(), world.pitch, world.colours.data());
  scatter(world.colours.data(), 4, offset, batch);
}

void VertexTransform::attributes(const MeshView& mesh, Attributes wanted, const TriangleBatch& triangles, VertexBatch& batch,
                                 const LineBatch& lines, const PointBatch& points) const {
  batch.stride = vertex_stride(wanted);
  const bool has_colours = contains(wanted, Attributes::colour), two_sided = state_.two_sided_colours && has_colours;
  batch.back_slots = two_sided ? batch.size() : 0;
  if (batch.stride == 0 || (triangles.count == 0 && lines.empty() && points.empty())) return;
  make_room(batch.attributes, static_cast<std::size_t>(batch.size() + batch.back_slots) * static_cast<std::size_t>(batch.stride));
  const bool has_cosines = contains(wanted, Attributes::custom) && state_.vertex_cosines;
  const bool lit = has_cosines || (has_colours && (state_.vertex_lighting || (two_sided && state_.back_lighting)));

  list_used(triangles, lines, points, batch);
  WorldVertices& world = batch.world;
  fill_in_world(mesh, contains(wanted, Attributes::position) || lit, contains(wanted, Attributes::normal) || lit, world);
  const auto offset = [&](Attributes one) { return scalar_offset(wanted, one); };
  if (contains(wanted, Attributes::position)) scatter(world.points.data(), 3, offset(Attributes::position), batch);
  if (contains(wanted, Attributes::normal)) scatter(world.normals.data(), 3, offset(Attributes::normal), batch);
  if (contains(wanted, Attributes::tangent)) turn_tangents(mesh.tangents, offset(Attributes::tangent), batch);
  if (contains(wanted, Attributes::bitangent)) turn_tangents(mesh.bitangents, offset(Attributes::bitangent), batch);
  if (contains(wanted, Attributes::texcoord)) copy(mesh.texcoords, glm::vec2(0), offset(Attributes::texcoord), batch);
  if (has_cosines) fill_in_cosines(offset(Attributes::custom), batch);
  else if (contains(wanted, Attributes::custom)) copy(mesh.custom, glm::vec4(0), offset(Attributes::custom), batch);
  if (has_colours) fill_in_colours(state_.vertex_lighting, mesh.colours, offset(Attributes::colour), batch);
  const auto used = static_cast<std::size_t>(world.count);
  write_texture_coordinates(mesh, state_, wanted, std::span(world.slots).first(used), std::span(world.sources).first(used), batch);
  interpolate_clipped(batch, 0);
  if (two_sided) add_back_faces(mesh, offset(Attributes::colour), batch);
}

void VertexTransform::add_back_faces(const MeshView& mesh, int offset, VertexBatch& batch) const {
  // Their records differ in the colours alone.
  const auto back = static_cast<std::size_t>(batch.back_slots), length = back * static_cast<std::size_t>(batch.stride);
  std::copy_n(batch.attributes.begin(), length, batch.attributes.begin() + static_cast<std::ptrdiff_t>(length));
  for (std::uint32_t& slot : batch.world.slots) slot += static_cast<std::uint32_t>(back);
  for (float& n : batch.world.normals) n = -n;
  fill_in_colours(state_.back_lighting ? state_.back_lighting : state_.vertex_lighting,
                  mesh.back_colours.empty() ? mesh.colours : mesh.back_colours, offset, batch);
  interpolate_clipped(batch, back);
}

void VertexTransform::fog_coordinates(const MeshView& mesh, VertexBatch& batch) const {
  take_fog_coordinates(mesh, batch);
  if (!mesh.fog_coordinates.empty()) interpolate_clipped_fog(batch);
  copy_fog_to_back_faces(batch);
}

void VertexTransform::fog_shares(const MeshView& mesh, const FogState& fog, VertexBatch& batch) const {
  take_fog_coordinates(mesh, batch);
  const std::size_t size = batch.fog_coordinates.size();
  batch.fog_coordinates.resize(size + kKernelPadding);
  kernels_.fog_shares(fog, static_cast<int>(batch.source.size()), batch.fog_coordinates.data());
  batch.fog_coordinates.resize(size);
  interpolate_clipped_fog(batch);
  copy_fog_to_back_faces(batch);
}

}  // namespace tuberia
