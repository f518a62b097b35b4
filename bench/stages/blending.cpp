// Blending of blocks in memory with targets of each format. The floor copies the fragments' colours.

#include <algorithm>
#include <iterator>

#include "bench/stages/stage_chain.hpp"
#include "bench/stages/stages.hpp"
#include "pipeline/blending.hpp"
#include "pipeline/fragment_shading.hpp"

namespace tuberia::bench {
namespace {

constexpr std::size_t kBlocks = 128;  // with their pixels less than the second cache

struct BlendCase {
  const char* what;
  BlendMode mode;
  ColourFormat format;
};

constexpr BlendCase kCases[] = {
    {"replace_rgba8", BlendMode::replace, ColourFormat::rgba8},
    {"replace_srgb8", BlendMode::replace, ColourFormat::srgb8},
    {"source_over_rgba8", BlendMode::source_over, ColourFormat::rgba8},
    {"source_over_srgb8", BlendMode::source_over, ColourFormat::srgb8},
    {"source_over_rgba32f", BlendMode::source_over, ColourFormat::rgba32f},
    {"additive_rgba8", BlendMode::additive, ColourFormat::rgba8},
};

// Gouraud colours, half transparent.
std::vector<FragmentBlock> coloured_blocks(StageChain& chain, InstructionSet isa, Precision precision) {
  chain.run_through(Stage::bin);
  std::vector<FragmentBlock> blocks = chain.some_blocks(kBlocks);
  const FragmentShading shading(chain.draw.program, false, isa, precision);
  for (FragmentBlock& block : blocks) {
    shading(chain.chunk.view(), block);
    std::fill(std::begin(block.colour[3]), std::end(block.colour[3]), 0.5f);
  }
  return blocks;
}

void blend(benchmark::State& state, const GridShape& grid, const BlendCase& which, InstructionSet isa, Precision precision) {
  StageChain chain({.grid = grid, .colour_format = which.format}, isa, precision);
  const std::vector<FragmentBlock> blocks = coloured_blocks(chain, isa, precision);
  OutputState output = chain.accepted.output;
  output.blend.mode = which.mode;
  const Blending blending(output, isa, precision);
  for (auto _ : state)
    for (const FragmentBlock& block : blocks) blending(block, chain.target);
  set_rate(state, live_fragments(blocks));
}

void register_case(const BlendCase& which, const GridShape& grid, const char* size) {
  add_both_precisions("blending", which.what, size, [=](benchmark::State& state, InstructionSet isa, Precision precision) {
    blend(state, grid, which, isa, precision);
  });
}

}  // namespace

void register_blending() {
  for (const BlendCase& which : kCases) register_case(which, kLargeTriangles, kLargeName);
  register_case(kCases[0], kSmallTriangles, kSmallName);
  register_case(kCases[2], kSmallTriangles, kSmallName);
  add_floor("blending", "source", kLargeName, kBlocks * kBlockPixels, sizeof(float) * 4);
}

}  // namespace tuberia::bench
