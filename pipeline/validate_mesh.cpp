#include "pipeline/validate_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "math/fixed_point.hpp"

namespace tuberia {
namespace {

Refusal check_length(const char* what, std::size_t length, std::size_t vertices) {
  if (length == 0 || length == vertices) return {};
  return Error{"the mesh has " + std::to_string(vertices) + " positions but " + std::to_string(length) + " " + what};
}

/// The first index that is out of range. Pieces are searched in parallel, each for its own first.
Refusal check_indices(const MeshView& mesh, Workers& workers) {
  constexpr std::size_t kPiece = 1 << 16;
  const std::span<const std::uint32_t> indices = mesh.indices;
  const auto vertices = static_cast<std::uint32_t>(mesh.vertex_count());
  const std::size_t pieces = (indices.size() + kPiece - 1) / kPiece;
  std::vector<std::uint32_t> largest(pieces, 0);
  parallel_for(workers, static_cast<std::int64_t>(pieces), [&](std::int64_t piece, int) {
    const auto i = static_cast<std::size_t>(piece);
    const auto part = indices.subspan(i * kPiece, std::min(kPiece, indices.size() - i * kPiece));
    std::uint32_t most = 0;
    for (const std::uint32_t index : part) most = std::max(most, index);
    largest[i] = most;
  });
  if (std::none_of(largest.begin(), largest.end(), [&](std::uint32_t most) { return most >= vertices; })) return {};
  const auto culprit = std::find_if(indices.begin(), indices.end(), [&](std::uint32_t index) { return index >= vertices; });
  return Error{"index " + std::to_string(culprit - indices.begin()) + " is " + std::to_string(*culprit) +
               ", but the mesh has " + std::to_string(vertices) + " vertices"};
}

Refusal check_positions(const MeshView& mesh) {
  const std::pair<const char*, std::size_t> kinds[] = {
      {"positions", mesh.positions.size()}, {"clip_positions", mesh.clip_positions.size()}, {"screen_positions", mesh.screen_positions.size()}};
  const char* found = nullptr;
  for (const auto& [name, length] : kinds) {
    if (length == 0) continue;
    if (found != nullptr) return Error{"the mesh has " + std::string(found) + " and " + name + "; it may have one kind of positions only"};
    found = name;
  }
  return {};
}

Refusal check_screen_vertices(std::span<const ScreenVertex> vertices) {
  const auto in_band = [](std::int32_t units) { return units >= -kGuardBandUnits && units <= kGuardBandUnits; };
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const ScreenVertex& v = vertices[i];
    const std::string name = "screen vertex " + std::to_string(i);
    if (!in_band(v.x) || !in_band(v.y))
      return Error{name + " at (" + std::to_string(v.x) + ", " + std::to_string(v.y) + ") units leaves the guard band of +-" +
                   std::to_string(kGuardBandUnits)};
    if (!(v.depth >= 0 && v.depth <= 1)) return Error{name + " has the depth " + words_of(v.depth) + ", outside [0, 1]"};
    if (!(v.w > 0) || !std::isfinite(v.w)) return Error{name + " has w " + words_of(v.w) + "; it must be positive and finite"};
  }
  return {};
}

Refusal check_lengths(const MeshView& mesh) {
  const std::size_t vertices = mesh.vertex_count();
  const std::pair<const char*, std::size_t> arrays[] = {
      {"normals", mesh.normals.size()}, {"texture coordinates", mesh.texcoords.size()}, {"colours", mesh.colours.size()},
      {"custom attributes", mesh.custom.size()}, {"back colours", mesh.back_colours.size()},
      {"fog coordinates", mesh.fog_coordinates.size()}, {"edge flags", mesh.edge_flags.size()},
      {"tangents", mesh.tangents.size()}, {"bitangents", mesh.bitangents.size()}};
  for (const auto& [name, length] : arrays)
    if (auto refusal = check_length(name, length, vertices)) return refusal;
  for (std::size_t unit = 0; unit < mesh.unit_texcoords.size(); ++unit) {
    const std::string name = "texture coordinates of unit " + std::to_string(unit);
    if (auto refusal = check_length(name.c_str(), mesh.unit_texcoords[unit].size(), vertices)) return refusal;
  }
  return {};
}

Refusal check_lighting(const MeshView& mesh, const std::optional<Lighting>& lighting, const std::string& name) {
  if (!lighting) return {};
  if (mesh.normals.empty()) return Error{name + " needs normals, which the mesh does not have"};
  if (!mesh.screen_positions.empty()) return Error{name + " needs positions in the world, but the mesh has screen_positions"};
  if (const Refusal refusal = refusal_of(*lighting)) return Error{name + ": " + refusal->message};
  return {};
}

}  // namespace

Refusal check_mesh(const MeshView& mesh, Workers& workers) {
  if (auto refusal = check_positions(mesh)) return refusal;
  const std::size_t vertices = mesh.vertex_count();
  if (vertices >= 0x2aaaaaaau) return Error{"the mesh has " + std::to_string(vertices) + " vertices, more than one draw takes"};
  if (auto refusal = check_lengths(mesh)) return refusal;
  if (auto refusal = check_screen_vertices(mesh.screen_positions)) return refusal;
  return check_indices(mesh, workers);
}

Refusal check_program(const DrawCall& draw) {
  if (!draw.program.is_set()) return Error{"the draw has no fragment program"};
  const ProgramInterface& program = draw.program.interface();
  if (const Refusal refusal = program.refusal(draw.program.uniforms()))
    return Error{"program '" + std::string(program.name) + "': " + refusal->message};
  const MeshView& mesh = draw.mesh;
  const auto needs = [&](Attributes one, bool missing, const char* what) -> Refusal {
    if (!contains(program.attributes(), one) || !missing) return {};
    return Error{"program '" + std::string(program.name) + "' reads " + what + ", which the mesh does not have"};
  };
  if (auto refusal = needs(Attributes::position, !mesh.screen_positions.empty(), "positions in the world")) return refusal;
  if (auto refusal = needs(Attributes::normal, mesh.normals.empty(), "normals")) return refusal;
  if (auto refusal = needs(Attributes::texcoord, mesh.texcoords.empty(), "texture coordinates")) return refusal;
  if (auto refusal = needs(Attributes::custom, mesh.custom.empty() && !draw.state.transform.vertex_cosines, "custom attributes")) return refusal;
  if (auto refusal = needs(Attributes::tangent, mesh.tangents.empty(), "tangents")) return refusal;
  if (auto refusal = needs(Attributes::bitangent, mesh.bitangents.empty(), "bitangents")) return refusal;
  const TransformState& transform = draw.state.transform;
  if (auto refusal = check_lighting(mesh, transform.vertex_lighting, "vertex lighting")) return refusal;
  if (auto refusal = check_lighting(mesh, transform.vertex_cosines, "vertex cosines")) return refusal;
  if (!transform.two_sided_colours) return {};
  return check_lighting(mesh, transform.back_lighting, "the lighting of back faces");
}

Refusal check_precision(const ProgramInterface& program, Precision precision) {
  if (precision == Precision::exact || precision == Precision::fast) return {};
  if (!is_one_ingredient(precision))
    return Error{"the pipeline's precision is " + std::to_string(static_cast<int>(precision)) + ", which is neither exact nor fast nor one ingredient of fast"};
  if (program.has_ingredients) return {};
  return Error{"program '" + std::string(program.name) + "' has kernels for exact and fast, not for the ingredient '" +
               std::string(name_of(precision)) + "' of fast alone"};
}

}  // namespace tuberia
