// Clipping: when nothing, one triangle, or every triangle of a chunk crosses the near plane. The
// stage works in place, so every round begins with copying its input; the floor is that copy.

#include "bench/stages/stage_chain.hpp"
#include "bench/stages/stages.hpp"

namespace tuberia::bench {
namespace {

constexpr const char* kSize = "2048_triangles";

void clip(benchmark::State& state, Crossing crossing) {
  GridShape grid = kSmallTriangles;
  grid.crossing = crossing;
  StageChain chain({.grid = grid});
  chain.run_through(Stage::primitive_assembly);
  const TriangleBatch input = chain.chunk.triangles;
  int cut = 0;
  for (auto _ : state) {
    chain.chunk.triangles = input;
    chain.chunk.vertices.clipped.clear();
    cut = chain.clipping(chain.chunk.vertices, chain.chunk.triangles);
  }
  set_rate(state, grid.triangles());
  state.counters["cut"] = cut;
}

}  // namespace

void register_clipping() {
  add_scalar("clipping", "none_crosses", kSize, [](benchmark::State& state) { clip(state, Crossing::none); });
  add_scalar("clipping", "one_crosses", kSize, [](benchmark::State& state) { clip(state, Crossing::one); });
  add_scalar("clipping", "all_cross", kSize, [](benchmark::State& state) { clip(state, Crossing::all); });
  add_floor("clipping", "input", kSize, kSmallTriangles.triangles(), 5 * sizeof(std::uint32_t));
}

}  // namespace tuberia::bench
