// VertexTransform: positions, and the attributes of vertices whose triangles survived.

#include "bench/stages/stage_chain.hpp"
#include "bench/stages/stages.hpp"

namespace tuberia::bench {
namespace {

constexpr const char* kSize = "1089_vertices";
constexpr std::size_t kClipVertexBytes = 4 * sizeof(float) + sizeof(std::uint32_t);  // x, y, z, w, outcode

void positions(benchmark::State& state, InstructionSet isa) {
  StageChain chain({.grid = kSmallTriangles}, isa);
  chain.run_through(Stage::vertex_fetch);
  for (auto _ : state) chain.vertex_transform.positions(chain.draw.mesh, chain.chunk.vertices);
  set_rate(state, kSmallTriangles.vertices());
}

void attributes(benchmark::State& state, const StageSubject& subject, Attributes wanted, InstructionSet isa) {
  StageChain chain(subject, isa);
  chain.run_through(Stage::culling);
  for (auto _ : state)
    chain.vertex_transform.attributes(chain.draw.mesh, wanted, chain.chunk.triangles, chain.chunk.vertices);
  set_rate(state, subject.grid.vertices());
}

void unlit(benchmark::State& state, InstructionSet isa) {
  attributes(state, {.grid = kSmallTriangles}, Attributes::colour, isa);
}

void lit(benchmark::State& state, InstructionSet isa) {
  attributes(state, {.grid = kSmallTriangles, .vertex_lighting = Lighting{.specular = glm::vec3(0.5f)}}, Attributes::colour, isa);
}

// World positions and normals, as lighting at every fragment reads them.
void world(benchmark::State& state, InstructionSet isa) {
  attributes(state, {.grid = kSmallTriangles}, Attributes::position | Attributes::normal, isa);
}

}  // namespace

void register_vertex_transform() {
  add_exact("vertex_transform", "positions", kSize, positions);
  add_floor("vertex_transform", "positions", kSize, kSmallTriangles.vertices(), kClipVertexBytes);
  add_exact("vertex_transform", "colour_unlit", kSize, unlit);
  add_exact("vertex_transform", "colour_lit", kSize, lit);
  add_floor("vertex_transform", "colour", kSize, kSmallTriangles.vertices(), sizeof(glm::vec4));
  add_exact("vertex_transform", "position_normal", kSize, world);
  add_floor("vertex_transform", "position_normal", kSize, kSmallTriangles.vertices(),
            sizeof(float) * static_cast<std::size_t>(vertex_stride(Attributes::position | Attributes::normal)));
}

}  // namespace tuberia::bench
