#pragma once
// A law that must hold on every instruction set is written once.

#include <catch2/catch.hpp>

#include "raster/instruction_set.hpp"

namespace tuberia::test {

/// The law, once for every instruction set of this machine.
template <class Law>
void for_every_instruction_set(Law&& law) {
  for (const InstructionSet set : supported_instruction_sets()) {
    INFO("instruction set " << name_of(set));
    law(set);
  }
}

/// The same for both precisions of each.
template <class Law>
void for_every_machine(Law&& law) {
  for_every_instruction_set([&](InstructionSet set) {
    for (const Precision precision : {Precision::exact, Precision::fast}) {
      INFO("precision " << (precision == Precision::exact ? "exact" : "fast"));
      law(set, precision);
    }
  });
}

}  // namespace tuberia::test
