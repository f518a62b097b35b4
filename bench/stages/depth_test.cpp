// DepthTest on blocks in memory, when all fragments pass and when none does. The target's depths do
// not change from round to round: those that pass are as near as what they wrote before.

#include "bench/stages/stage_chain.hpp"
#include "bench/stages/stages.hpp"
#include "pipeline/depth_test.hpp"

namespace tuberia::bench {
namespace {

constexpr std::size_t kBlocks = 128;  // with their pixels less than the second cache
constexpr std::size_t kDepthBytes = 2 * sizeof(std::int32_t);  // the block's and the target's

void test(benchmark::State& state, const GridShape& grid, Compare compare, InstructionSet isa, Precision precision) {
  StageChain chain({.grid = grid}, isa, precision);
  chain.run_through(Stage::bin);
  std::vector<FragmentBlock> blocks = chain.some_blocks(kBlocks);
  const std::size_t fragments = live_fragments(blocks);
  std::vector<std::uint64_t> covered;
  for (const FragmentBlock& block : blocks) covered.push_back(block.live);

  OutputState output = chain.accepted.output;
  output.depth.test = compare;
  const DepthTest depth_test(output, isa, precision);
  for (auto _ : state)
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      blocks[i].live = covered[i];
      depth_test(blocks[i], chain.target);
    }
  set_rate(state, fragments);
  state.counters["passed"] = static_cast<double>(live_fragments(blocks)) / static_cast<double>(fragments);
}

void register_grid(const GridShape& grid, const char* size) {
  add_both_precisions("depth_test", "all_pass", size, [grid](benchmark::State& state, InstructionSet isa, Precision precision) {
    test(state, grid, Compare::less_equal, isa, precision);
  });
  add_both_precisions("depth_test", "none_passes", size, [grid](benchmark::State& state, InstructionSet isa, Precision precision) {
    test(state, grid, Compare::greater, isa, precision);
  });
}

}  // namespace

void register_depth_test() {
  register_grid(kSmallTriangles, kSmallName);
  register_grid(kLargeTriangles, kLargeName);
  add_floor("depth_test", "all_pass", kLargeName, kBlocks * kBlockPixels, kDepthBytes);
}

}  // namespace tuberia::bench
