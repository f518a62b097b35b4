#pragma once
// Stages 6 to 9 one after the other, a block of 8x8 fragments at a time: for all the state that the
// fused loops of pipeline/fragment_chain-inl.hpp leave out, and for draws that are watched or
// counted. Both are made of the same inline functions, so a draw that either can do comes out the
// same, bit for bit.

#include <bit>
#include <span>
#include <vector>

#include "pipeline/fragment_program.hpp"
#include "pipeline/observer.hpp"
#include "raster/fragment_block.hpp"
#include "raster/shape_coverage.hpp"

namespace tuberia {

struct FragmentCounters {
  std::int64_t fragments = 0, shaded = 0, samples_passed = 0;
  DrawStatistics statistics() const noexcept {
    return {.fragments = fragments, .fragments_shaded = shaded, .samples_passed = samples_passed};
  }
};

class FragmentStages {
 public:
  FragmentStages(const FragmentJob& job, const ProgramInterface& program, InstructionSet instruction_set, Precision precision)
      : job_(job), program_(program.kernels(instruction_set, precision)), blocks_(block_kernels(instruction_set, precision)),
        tests_early_(tests_depth_early(program, job.output)), shades_(shades(program, job.output)) {}

  /// The listed primitives of a chunk in one tile, in order. `blocks` is scratch memory.
  template <class Tap>
  void operator()(const Chunk& chunk, std::span<const std::uint16_t> primitives, const Tile& tile,
                  std::vector<FragmentBlock>& blocks, FragmentCounters& counters, const Tap& tap) const {
    const ChunkView view = chunk.view();
    for (const std::uint16_t number : primitives) {
      blocks.clear();
      rasterize(view, number, tile, blocks);
      for (FragmentBlock& block : blocks) {
        tap.after(Stage::rasterization, chunk, block, tile);
        shade_and_store(chunk, view, tile, block, counters, tap);
      }
    }
  }

 private:
  void rasterize(const ChunkView& view, std::uint16_t number, const Tile& tile, std::vector<FragmentBlock>& blocks) const {
    const ScreenTriangle& triangle = view.triangles[number];
    if (view.shapes == nullptr || view.shapes[number].kind == ScreenShape::Kind::triangle)
      blocks_.rasterize(triangle, tile, job_.output.clip, blocks);
    else
      cover_shape(triangle, view.shapes[number], job_.output.stipple, tile, job_.output.clip, blocks);
  }

  template <class Tap>
  void shade_and_store(const Chunk& chunk, const ChunkView& view, const Tile& tile, FragmentBlock& block,
                       FragmentCounters& counters, const Tap& tap) const {
    const auto stage = [&](Stage name, const auto& work) {
      if (block.live == 0) return;
      tap.before(name, chunk, block, tile);
      work();
      tap.after(name, chunk, block, tile);
    };
    counters.fragments += std::popcount(block.live);
    if (tests_early_) stage(Stage::depth_test, [&] { blocks_.depth_test(block, job_.output, tile); });
    if (shades_) {
      counters.shaded += std::popcount(block.live);
      stage(Stage::fragment_shading, [&] {
        program_.shade(job_, view, block);
        blocks_.fog(block, view, job_.output);
      });
    }
    if (!tests_early_) {
      stage(Stage::alpha_test, [&] { blocks_.alpha_test(block, job_.output); });
      stage(Stage::depth_test, [&] { blocks_.depth_test(block, job_.output, tile); });
    }
    if (job_.output.blend.write) stage(Stage::blending, [&] { blocks_.blend(block, job_.output, tile); });
    for (int s = 0; s < block.samples; ++s) counters.samples_passed += std::popcount(block.sample_live[s]);
  }

  FragmentJob job_;
  const ProgramKernels& program_;
  const BlockKernels& blocks_;
  bool tests_early_;  // nothing later can drop a fragment, so hidden ones need not be shaded
  bool shades_;
};

}  // namespace tuberia
