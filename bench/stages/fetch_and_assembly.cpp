// VertexFetch and PrimitiveAssembly: indices to slots, slots to triangles.

#include "bench/stages/stage_chain.hpp"
#include "bench/stages/stages.hpp"

namespace tuberia::bench {
namespace {

constexpr const char* kSize = "2048_triangles";
constexpr std::size_t kTriangleBytes = 5 * sizeof(std::uint32_t);  // as a TriangleBatch stores it
constexpr std::size_t kSlotBytes = 3 * sizeof(std::uint32_t);

void fetch(benchmark::State& state) {
  StageChain chain({.grid = kSmallTriangles});
  Chunk& chunk = chain.chunk;
  for (auto _ : state) chunk.fetch(chain.draw.mesh, Topology::triangles, chunk.range, chunk.vertices, chunk.slots);
  set_rate(state, kSmallTriangles.triangles());
}

void assemble(benchmark::State& state, Topology topology) {
  StageChain chain({.grid = kSmallTriangles});
  chain.run_through(Stage::vertex_fetch);
  const PrimitiveAssembly assembly({.topology = topology});
  for (auto _ : state) assembly(chain.chunk.slots, chain.chunk.range, chain.chunk.triangles);
  set_rate(state, kSmallTriangles.triangles());
}

}  // namespace

void register_fetch_and_assembly() {
  add_scalar("vertex_fetch", "indexed", kSize, fetch);
  add_floor("vertex_fetch", "indexed", kSize, kSmallTriangles.triangles(), kSlotBytes);
  add_scalar("primitive_assembly", "list", kSize, [](benchmark::State& state) { assemble(state, Topology::triangles); });
  add_scalar("primitive_assembly", "strip", kSize, [](benchmark::State& state) { assemble(state, Topology::triangle_strip); });
  add_scalar("primitive_assembly", "fan", kSize, [](benchmark::State& state) { assemble(state, Topology::triangle_fan); });
  add_floor("primitive_assembly", "list", kSize, kSmallTriangles.triangles(), kTriangleBytes);
}

}  // namespace tuberia::bench
