#pragma once
// Instruction counts that were recorded, and how new ones compare with them.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace tuberia::bench {

struct InstructionCount {
  std::string workload;
  std::int64_t instructions = 0;
  bool operator==(const InstructionCount&) const = default;
};

struct Baseline {
  std::string compiler;
  std::vector<InstructionCount> counts;
};

/// More than this above the recorded count fails; as much below is worth recording.
inline constexpr double kTolerancePercent = 3;

/// Text: lines of `compiler NAME AND VERSION` and `WORKLOAD INSTRUCTIONS`; # begins a comment, empty
/// lines are passed over. Error naming `file` and the line of whatever else there is.
Result<Baseline> parse_baseline(std::string_view text, const std::string& file);

/// The text that parse_baseline reads.
std::string text_of(const Baseline& baseline);

enum class Verdict { holds, better, worse, not_recorded, not_counted };

struct Comparison {
  std::string workload;
  Verdict verdict = Verdict::holds;
  std::int64_t recorded = 0, counted = 0;  // 0 where there is none

  double percent() const noexcept {
    return 100.0 * (static_cast<double>(counted) / static_cast<double>(recorded) - 1);
  }
};

/// In the order of the counted ones; those that are only recorded come last.
std::vector<Comparison> compare(const std::vector<InstructionCount>& recorded, const std::vector<InstructionCount>& counted);

/// Whether the guard lets this pass: nothing is worse, and both sides have the same workloads.
bool passes(const std::vector<Comparison>& comparisons);

/// For people: a line each, and what is to be done.
std::string table_of(const std::vector<Comparison>& comparisons);

}  // namespace tuberia::bench
