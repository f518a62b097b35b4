// Rasterization, second half: triangles to 8x8 blocks of fragments in memory. The fused tile loops
// keep these in registers; here every block is written, and the floor is a copy of what is written.

#include "bench/stages/stage_chain.hpp"
#include "bench/stages/stages.hpp"

namespace tuberia::bench {
namespace {

struct Written {
  std::size_t blocks = 0, fragments = 0;
};

// Every triangle into every tile it may touch, each into the same few blocks.
template <class Each>
void rasterize_all(StageChain& chain, std::vector<FragmentBlock>& blocks, Each&& each) {
  for (int number = 0; number < chain.target.tile_count(); ++number) {
    const Tile tile = chain.target.tile(number);
    for (const std::uint16_t triangle : chain.chunk.tiles.of_tile(number)) {
      blocks.clear();
      chain.blocks.rasterize(chain.chunk.screen_triangles[triangle], tile, chain.accepted.clip, blocks);
      each(blocks);
    }
  }
}

Written count_written(StageChain& chain) {
  Written written;
  std::vector<FragmentBlock> blocks;
  rasterize_all(chain, blocks, [&](const std::vector<FragmentBlock>& found) {
    written.blocks += found.size();
    written.fragments += live_fragments(found);
  });
  return written;
}

void rasterize(benchmark::State& state, const GridShape& grid, InstructionSet isa, Precision precision) {
  StageChain chain({.grid = grid}, isa, precision);
  chain.run_through(Stage::bin);
  const Written written = count_written(chain);
  std::vector<FragmentBlock> blocks;
  for (auto _ : state) rasterize_all(chain, blocks, [](const std::vector<FragmentBlock>&) {});
  set_rate(state, written.fragments);
  state.counters["fragments_a_block"] = static_cast<double>(written.fragments) / static_cast<double>(written.blocks);
}

// The blocks' bytes, one block after the other, into the place of a few.
void copy_blocks(benchmark::State& state, const GridShape& grid) {
  StageChain chain({.grid = grid});
  chain.run_through(Stage::bin);
  const Written written = count_written(chain);
  constexpr std::size_t kPlaces = 8;
  const std::vector<FragmentBlock> from(kPlaces);
  std::vector<FragmentBlock> to(kPlaces);
  for (auto _ : state)
    for (std::size_t i = 0; i < written.blocks; ++i) {
      to[i % kPlaces] = from[i % kPlaces];
      benchmark::ClobberMemory();
    }
  set_rate(state, written.fragments);
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(written.blocks * sizeof(FragmentBlock)));
}

void register_grid(const GridShape& grid, const char* size) {
  add_both_precisions("rasterization", "blocks", size,
                      [grid](benchmark::State& state, InstructionSet isa, Precision precision) { rasterize(state, grid, isa, precision); });
  benchmark::RegisterBenchmark(benchmark_name("rasterization", "blocks_floor", size, "memcpy", Precision::exact).c_str(),
                               [grid](benchmark::State& state) { copy_blocks(state, grid); });
}

}  // namespace

void register_rasterization() {
  register_grid(kSmallTriangles, kSmallName);
  register_grid(kLargeTriangles, kLargeName);
}

}  // namespace tuberia::bench
