// Rasterization, first half: triangle setup, and binning into tiles.

#include "bench/stages/stage_chain.hpp"
#include "bench/stages/stages.hpp"

namespace tuberia::bench {
namespace {

constexpr const char* kSize = "2048_triangles";
constexpr int kWidePixels = 8192;  // per side: each triangle touches about 16 tiles

GridShape grid_of(int target_pixels) {
  GridShape grid = kSmallTriangles;
  grid.target_pixels = target_pixels;
  return grid;
}

void set_up(benchmark::State& state, InstructionSet isa) {
  StageChain chain({.grid = kSmallTriangles}, isa);
  chain.run_through(Stage::culling);
  for (auto _ : state)
    chain.rasterization.set_up(chain.chunk.triangles, chain.chunk.vertices, chain.chunk.screen_triangles);
  set_rate(state, kSmallTriangles.triangles());
}

void bin(benchmark::State& state, int target_pixels) {
  StageChain chain({.grid = grid_of(target_pixels)});
  chain.run_through(Stage::set_up);
  TileLists tiles;
  for (auto _ : state)
    chain.rasterization.bin(chain.chunk.screen_triangles, chain.target.tiles_per_row(), chain.target.tile_rows(), tiles);
  set_rate(state, kSmallTriangles.triangles());

  std::size_t entries = 0;
  for (int number = 0; number < chain.target.tile_count(); ++number) entries += tiles.of_tile(number).size();
  state.counters["tiles_each"] = static_cast<double>(entries) / static_cast<double>(kSmallTriangles.triangles());
}

}  // namespace

void register_set_up_and_binning() {
  add_exact("rasterization", "set_up", kSize, set_up);
  add_floor("rasterization", "set_up", kSize, kSmallTriangles.triangles(), sizeof(ScreenTriangle));
  add_scalar("rasterization", "bin", kSize, [](benchmark::State& state) { bin(state, kSmallTriangles.target_pixels); });
  add_scalar("rasterization", "bin_wide", kSize, [](benchmark::State& state) { bin(state, kWidePixels); });
  add_floor("rasterization", "bin", kSize, kSmallTriangles.triangles(), sizeof(std::uint16_t));
}

}  // namespace tuberia::bench
