#pragma once
// Programs that read more and more attributes and do little else.

#include <vector>

#include "pipeline/fragment_program.hpp"

namespace tuberia::bench {

struct AttributeProgram {
  int scalars = 0;  // interpolated
  FragmentProgram program;
};

/// By growing number of scalars: 0, 2, 4, 8, 16.
std::vector<AttributeProgram> attribute_programs();

}  // namespace tuberia::bench
