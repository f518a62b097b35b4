#pragma once
// Between stages 7 and 8: accept or discard by alpha.

#include "raster/fragment_block.hpp"

namespace tuberia {

/// Alpha to coverage, then the alpha test (whose state has the name AlphaTest).
class AlphaTesting {
 public:
  AlphaTesting(const OutputState& state, InstructionSet instruction_set, Precision precision) noexcept
      : state_(state), kernels_(block_kernels(instruction_set, precision)) {}

  /// Clears the live bits of the samples and fragments that fail.
  void operator()(FragmentBlock& block) const { kernels_.alpha_test(block, state_); }

 private:
  OutputState state_;
  const BlockKernels& kernels_;
};

}  // namespace tuberia
