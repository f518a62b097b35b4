#pragma once
// What the options of every benchmark have in common.

#include <string>

#include "base/result.hpp"
#include "raster/instruction_set.hpp"

namespace tuberia::bench {

/// The instruction set called so, or the widest for "". Error when this machine lacks it.
inline Result<InstructionSet> instruction_set_from(const std::string& name) {
  if (name.empty()) return best_instruction_set();
  const auto chosen = instruction_set_named(name);
  if (!chosen || !is_supported(*chosen)) return Error{"this machine has no instruction set called " + name};
  return *chosen;
}

}  // namespace tuberia::bench
