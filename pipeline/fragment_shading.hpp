#pragma once
// Stage 7: the fragment program gives each fragment its colour.

#include "pipeline/fragment_program.hpp"

namespace tuberia {

class FragmentShading {
 public:
  FragmentShading(const FragmentProgram& program, bool flat_shading, InstructionSet instruction_set, Precision precision)
      : job_{.output = {}, .uniforms = program.uniforms(), .flat_shading = flat_shading},
        kernels_(program.interface().kernels(instruction_set, precision)) {}

  /// Colours of the live fragments; fragments that the program discards lose their live bit.
  /// chunk: where the block's triangle and the attributes of its vertices are.       [C 4.4]
  void operator()(const ChunkView& chunk, FragmentBlock& block) const { kernels_.shade(job_, chunk, block); }

 private:
  FragmentJob job_;
  const ProgramKernels& kernels_;
};

}  // namespace tuberia
