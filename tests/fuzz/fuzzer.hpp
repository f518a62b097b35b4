#pragma once
// What the fuzzers have in common.

#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/targets.hpp"

namespace tuberia::fuzz {

/// Ends the process if something is wrong; that is how libFuzzer learns of it.
inline int require_well(const std::string& wrong) {
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "%s\n", wrong.c_str());
  std::abort();
}

}  // namespace tuberia::fuzz
