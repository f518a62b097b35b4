#include "pipeline/validate.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "math/fixed_point.hpp"

namespace tuberia {
namespace {

using Refusal = std::optional<Error>;

Refusal check_length(const char* what, std::size_t length, std::size_t vertices) {
  if (length == 0 || length == vertices) return {};
  return Error{"the mesh has " + std::to_string(vertices) + " positions but " + std::to_string(length) + " " + what};
}

/// The first index that is out of range. Pieces are searched in parallel, each for its own first.
Refusal check_indices(const MeshView& mesh, Workers& workers) {
  constexpr std::size_t kPiece = 1 << 16;
  const std::span<const std::uint32_t> indices = mesh.indices;
  const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
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

Refusal check_mesh(const MeshView& mesh, Workers& workers) {
  const std::size_t vertices = mesh.positions.size();
  if (vertices >= 0x2aaaaaaau) return Error{"the mesh has " + std::to_string(vertices) + " vertices, more than one draw takes"};
  if (auto refusal = check_length("normals", mesh.normals.size(), vertices)) return refusal;
  if (auto refusal = check_length("texture coordinates", mesh.texcoords.size(), vertices)) return refusal;
  if (auto refusal = check_length("colours", mesh.colours.size(), vertices)) return refusal;
  if (auto refusal = check_length("custom attributes", mesh.custom.size(), vertices)) return refusal;
  return check_indices(mesh, workers);
}

Refusal check_program(const DrawCall& draw) {
  if (!draw.program.is_set()) return Error{"the draw has no fragment program"};
  const ProgramInterface& program = draw.program.interface();
  if (const char* refusal = program.refusal(draw.program.uniforms()))
    return Error{"program '" + std::string(program.name) + "': " + refusal};
  const auto& lighting = draw.state.transform.vertex_lighting;
  const auto needs = [&](Attributes one, bool missing, const char* what) -> Refusal {
    if (!contains(program.attributes(), one) || !missing) return {};
    return Error{"program '" + std::string(program.name) + "' reads " + what + ", which the mesh does not have"};
  };
  if (auto refusal = needs(Attributes::normal, draw.mesh.normals.empty(), "normals")) return refusal;
  if (auto refusal = needs(Attributes::texcoord, draw.mesh.texcoords.empty(), "texture coordinates")) return refusal;
  if (auto refusal = needs(Attributes::custom, draw.mesh.custom.empty(), "custom attributes")) return refusal;
  if (!lighting) return {};
  if (draw.mesh.normals.empty()) return Error{"vertex lighting needs normals, which the mesh does not have"};
  if (lighting->light_count < 0 || lighting->light_count > Lighting::kMaxLights)
    return Error{"vertex lighting has " + std::to_string(lighting->light_count) + " lights; 0 to " +
                 std::to_string(Lighting::kMaxLights) + " are possible"};
  return {};
}

Refusal check_viewport(const Viewport& viewport, const DepthRange& range) {
  constexpr int kMost = RenderTarget::kMaxSize;
  const auto within = [](int x, int low) { return x >= low && x <= kMost; };
  if (!within(viewport.width_pixels, 0) || !within(viewport.height_pixels, 0) || !within(viewport.x, -kMost) ||
      !within(viewport.y, -kMost))
    return Error{"the viewport " + std::to_string(viewport.width_pixels) + "x" + std::to_string(viewport.height_pixels) +
                 " at (" + std::to_string(viewport.x) + ", " + std::to_string(viewport.y) + ") is out of range: sizes 0 to " +
                 std::to_string(kMost) + ", corners within +-" + std::to_string(kMost)};
  const auto in_unit = [](float depth) { return depth >= 0 && depth <= 1; };
  if (!in_unit(range.near_depth) || !in_unit(range.far_depth))
    return Error{"the depth range " + std::to_string(range.near_depth) + " to " + std::to_string(range.far_depth) +
                 " leaves [0, 1]"};
  return {};
}

}  // namespace

Result<AcceptedDraw> validate(const DrawCall& draw, const RenderTarget& target, Workers& workers) {
  const PipelineState& state = draw.state;
  const Viewport viewport = state.viewport.viewport.value_or(Viewport{0, 0, target.width(), target.height()});
  const DepthRange& range = state.viewport.depth_range;
  if (auto refusal = check_mesh(draw.mesh, workers)) return *std::move(refusal);
  if (auto refusal = check_program(draw)) return *std::move(refusal);
  if (auto refusal = check_viewport(viewport, range)) return *std::move(refusal);

  AcceptedDraw accepted;
  accepted.viewport = viewport;
  accepted.clip = intersection(target.bounds(), {viewport.x, viewport.y, viewport.x + viewport.width_pixels,
                                                 viewport.y + viewport.height_pixels});
  if (state.rasterization.scissor) accepted.clip = intersection(accepted.clip, *state.rasterization.scissor);
  accepted.output = {.depth = state.depth,
                     .blend = state.blend,
                     .depth_format = target.depth_format(),
                     .colour_format = target.colour_format(),
                     .min_depth = std::min(range.near_depth, range.far_depth),
                     .max_depth = std::max(range.near_depth, range.far_depth),
                     .clip = accepted.clip,
                     .stencil = state.stencil,
                     .alpha_test = state.alpha_test,
                     .fog = state.fog,
                     .multisampling = state.multisampling,
                     .stipple = state.rasterization.line.stipple.value_or(StipplePattern{})};
  accepted.output.samples = 1;
  accepted.is_everyday = is_everyday(accepted.output) && makes_triangles(state.assembly.topology) &&
                         state.rasterization.front_mode == PolygonMode::fill && state.rasterization.back_mode == PolygonMode::fill;
  return accepted;
}

}  // namespace tuberia
