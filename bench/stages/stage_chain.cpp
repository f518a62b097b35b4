#include "bench/stages/stage_chain.hpp"

#include <bit>

#include "bench/peers/meshes.hpp"

namespace tuberia::bench {
namespace {

constexpr float kTilt = 0.2f;            // how much w grows with y
constexpr float kTexelsPerPixel = 1.4f;  // half way between two mipmap levels
constexpr float kTextureSize = 512;      // texels

// w = 1 + kTilt * y, and x, y, z as they are.
glm::mat4 tilted_clip_from_world() {
  glm::mat4 clip_from_world(1.0f);
  clip_from_world[1][3] = kTilt;
  return clip_from_world;
}

bool crosses(Crossing crossing, std::size_t vertex, std::size_t vertices_per_row) {
  if (crossing == Crossing::one) return vertex == vertices_per_row - 1;  // a corner of one triangle only
  return crossing == Crossing::all && vertex / vertices_per_row % 2 == 1;
}

GridMesh make_mesh(const GridShape& shape) {
  const WorkloadMesh grid = jittered_grids(shape.quads_per_side, shape.quads_per_side, 1, LayerOrder::back_to_front);
  const auto vertices_per_row = static_cast<std::size_t>(shape.quads_per_side + 1);
  const float repeats = static_cast<float>(shape.target_pixels) * kTexelsPerPixel / kTextureSize;
  GridMesh mesh{.positions = {}, .normals = grid.normals, .texcoords = {}, .colours = {}, .indices = grid.indices};
  for (std::size_t i = 0; i < grid.positions.size(); ++i) {
    // Multiplied with the w it will get, a vertex lands on its place in the grid.
    const glm::vec2 ndc(grid.positions[i]);
    const float w = 1 / (1 - kTilt * ndc.y);
    const float z_ndc = crosses(shape.crossing, i, vertices_per_row) ? -1.5f : 0.4f * ndc.x;
    mesh.positions.push_back(w * glm::vec3(ndc, z_ndc));
    mesh.texcoords.push_back(0.5f * repeats * ndc);
    const Rgba8& c = grid.colours[i];
    mesh.colours.push_back(glm::vec4(c.r, c.g, c.b, c.a) / 255.0f);
  }
  return mesh;
}

DrawCall make_draw(const GridMesh& mesh, const StageSubject& subject) {
  DrawCall draw{.mesh = {.positions = mesh.positions, .normals = mesh.normals, .texcoords = mesh.texcoords,
                         .colours = mesh.colours, .custom = {}, .indices = mesh.indices},
                .program = subject.program, .state = {}};
  draw.state.transform.clip_from_world = tilted_clip_from_world();
  draw.state.transform.vertex_lighting = subject.vertex_lighting;
  draw.state.culling.cull = subject.cull;
  return draw;
}

AcceptedDraw accept(const DrawCall& draw, const RenderTarget& target) {
  Workers workers(1);
  return *validate(draw, target, workers);
}

}  // namespace

StageChain::StageChain(const StageSubject& subject, InstructionSet isa, Precision precision)
    : mesh(make_mesh(subject.grid)), draw(make_draw(mesh, subject)),
      target(*RenderTarget::create(subject.grid.target_pixels, subject.grid.target_pixels, subject.colour_format)),
      accepted(accept(draw, target)), limits(clip_limits(accepted.viewport, draw.state.clipping.volume)),
      vertex_transform(draw.state.transform, limits, isa), primitive_assembly(draw.state.assembly), clipping(limits),
      perspective_divide(screen_map(accepted.viewport, draw.state.viewport.depth_range, draw.state.clipping.volume), isa),
      culling(draw.state.culling, accepted.clip, isa), rasterization(accepted.clip, isa, precision),
      blocks(block_kernels(isa, precision)) {
  chunk.range = {0, static_cast<int>(subject.grid.triangles())};
}

void StageChain::run_through(Stage last) {
  chunk.fetch(draw.mesh, draw.state.assembly.topology, chunk.range, chunk.vertices, chunk.slots);
  if (last >= Stage::positions) vertex_transform.positions(draw.mesh, chunk.vertices);
  if (last >= Stage::primitive_assembly) primitive_assembly(chunk.slots, chunk.range, chunk.triangles);
  if (last >= Stage::clipping) clipping(chunk.vertices, chunk.triangles);
  if (last >= Stage::perspective_divide) perspective_divide(chunk.vertices);
  if (last >= Stage::culling) culling(chunk.vertices, chunk.triangles);
  if (last >= Stage::attributes)
    vertex_transform.attributes(draw.mesh, draw.program.interface().attributes(), chunk.triangles, chunk.vertices);
  if (last >= Stage::set_up) rasterization.set_up(chunk.triangles, chunk.vertices, chunk.screen_triangles);
  if (last >= Stage::bin) rasterization.bin(chunk.screen_triangles, target.tiles_per_row(), target.tile_rows(), chunk.tiles);
}

std::vector<FragmentBlock> StageChain::some_blocks(std::size_t most) {
  std::vector<FragmentBlock> all, some;
  for (int number = 0; number < target.tile_count(); ++number)
    for (const std::uint16_t triangle : chunk.tiles.of_tile(number))
      blocks.rasterize(chunk.screen_triangles[triangle], target.tile(number), accepted.clip, all);
  if (all.size() <= most) return all;
  for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * all.size() / most]);
  return some;
}

std::size_t live_fragments(const std::vector<FragmentBlock>& blocks) noexcept {
  std::size_t count = 0;
  for (const FragmentBlock& block : blocks) count += static_cast<std::size_t>(std::popcount(block.live));
  return count;
}

}  // namespace tuberia::bench
