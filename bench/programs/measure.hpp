#pragma once
// Nanoseconds a fragment.

#include <optional>
#include <string>
#include <vector>

#include "raster/instruction_set.hpp"

namespace tuberia::bench {

struct MeasureOptions {
  double seconds = 20;  // about, for each precision
  int fewest_rounds = 11;
  InstructionSet instruction_set = InstructionSet::baseline;
};

/// One program on one thread: nanoseconds of processor time for each fragment, at both precisions.
struct ProgramCost {
  enum class Kind { program, base, technique, combination };
  Kind kind = Kind::program;
  std::string name;
  double exact = 0, fast = 0;                      // medians
  double exact_low = 0, exact_high = 0;            // quartiles, as shares of flat times flat's median
  // Of combinations: the increment over the base, by the sum of its parts' increments.
  std::optional<double> exact_ratio{}, fast_ratio{};
};

/// The most that a combination may cost, by the sum of its parts.
inline constexpr double kMostForCombination = 1.15;

/// Every program of the table over one slanted square that fills the picture. All take turns.
std::vector<ProgramCost> measure_programs(const MeasureOptions& options);

}  // namespace tuberia::bench
