#pragma once
// The table of a comparison, for people and for programs.

#include <span>
#include <string>

#include "base/result.hpp"
#include "bench/peers/comparison.hpp"

namespace tuberia::bench {

void print_heading(const Peer& ours, const Peer& theirs);
void print(const Timing& timing);

/// What is asked of all rows together; 0 asks nothing.
struct Requirement {
  double mean = 0, least = 0;  // of the ratios: their geometric mean, and the smallest
};

/// The closing lines. Returns whether the requirement is met. timings: at least one.
bool print_summary(std::span<const Timing> timings, const Requirement& requirement);

/// An array with one object a workload, in the order of the table.
Result<Nothing> write_json(const std::string& path, std::span<const Timing> timings);

}  // namespace tuberia::bench
