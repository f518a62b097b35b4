#pragma once
// Stage 9: fragments become pixels.

#include "raster/fragment_block.hpp"
#include "raster/render_target.hpp"

namespace tuberia {

class Blending {
 public:
  Blending(const OutputState& state, InstructionSet instruction_set, Precision precision) noexcept
      : state_(state), kernels_(block_kernels(instruction_set, precision)) {}

  /// Blends the live fragments' colours with the target's pixels and stores them. [C 4.6] [rules B1, B2]
  void operator()(const FragmentBlock& block, RenderTarget& target) const {
    kernels_.blend(block, state_, target.tile_at(block.left, block.top));
  }

 private:
  OutputState state_;
  const BlockKernels& kernels_;
};

}  // namespace tuberia
