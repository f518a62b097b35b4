// PerspectiveDivide and Culling. Culling works in place, so every round begins with copying its
// input; the floor is that copy.

#include "bench/stages/stage_chain.hpp"
#include "bench/stages/stages.hpp"

namespace tuberia::bench {
namespace {

constexpr const char* kVertices = "1089_vertices";
constexpr const char* kTriangles = "2048_triangles";
constexpr std::size_t kScreenVertexBytes = 3 * sizeof(std::int32_t);  // x, y, depth

void divide(benchmark::State& state, InstructionSet isa) {
  StageChain chain({.grid = kSmallTriangles}, isa);
  chain.run_through(Stage::clipping);
  for (auto _ : state) chain.perspective_divide(chain.chunk.vertices);
  set_rate(state, kSmallTriangles.vertices());
}

void cull(benchmark::State& state, CullFace face, InstructionSet isa) {
  StageChain chain({.grid = kSmallTriangles, .cull = face}, isa);
  chain.run_through(Stage::perspective_divide);
  const TriangleBatch input = chain.chunk.triangles;
  for (auto _ : state) {
    chain.chunk.triangles = input;
    chain.culling(chain.chunk.vertices, chain.chunk.triangles);
  }
  set_rate(state, kSmallTriangles.triangles());
  state.counters["kept"] = chain.chunk.triangles.count;
}

}  // namespace

void register_divide_and_culling() {
  add_exact("perspective_divide", "project", kVertices, divide);
  add_floor("perspective_divide", "project", kVertices, kSmallTriangles.vertices(), kScreenVertexBytes);
  add_exact("culling", "all_kept", kTriangles,
            [](benchmark::State& state, InstructionSet isa) { cull(state, CullFace::back, isa); });
  add_exact("culling", "all_dropped", kTriangles,
            [](benchmark::State& state, InstructionSet isa) { cull(state, CullFace::front, isa); });
  add_floor("culling", "input", kTriangles, kSmallTriangles.triangles(), 5 * sizeof(std::uint32_t));
}

}  // namespace tuberia::bench
