#pragma once
// Stage 8: accept or discard by stencil code and nearness.

#include "raster/fragment_block.hpp"
#include "raster/render_target.hpp"

namespace tuberia {

class DepthTest {
 public:
  DepthTest(const OutputState& state, InstructionSet instruction_set, Precision precision) noexcept
      : state_(state), kernels_(block_kernels(instruction_set, precision)) {}

  /// Fills in the block's depth codes, clears the live bits of samples that fail either test, and
  /// stores the stencil codes of all and the depths of those that pass. [C 4.1, 4.5] [rules Z1, Z2]
  void operator()(FragmentBlock& block, RenderTarget& target) const {
    kernels_.depth_test(block, state_, target.tile_at(block.left, block.top));
  }

 private:
  OutputState state_;
  const BlockKernels& kernels_;
};

}  // namespace tuberia
