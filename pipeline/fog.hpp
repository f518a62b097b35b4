#pragma once
// Between stages 7 and 8: distance takes colour away.

#include "raster/fragment_block.hpp"

namespace tuberia {

class Fog {
 public:
  Fog(const OutputState& state, InstructionSet instruction_set, Precision precision) noexcept
      : state_(state), kernels_(block_kernels(instruction_set, precision)) {}

  /// Mixes the live fragments' colours with the fog's. chunk: where the fog coordinates of the
  /// vertices of the block's triangle are.
  void operator()(const ChunkView& chunk, FragmentBlock& block) const { kernels_.fog(block, chunk, state_); }

 private:
  OutputState state_;
  const BlockKernels& kernels_;
};

}  // namespace tuberia
