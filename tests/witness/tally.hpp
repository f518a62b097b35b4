#pragma once
// Many cases of a class, counted.

#include <cstdint>
#include <string>
#include <vector>

#include "base/parallel_for.hpp"
#include "tests/witness/comparison.hpp"

namespace tuberia::witness {

struct Tally {
  std::int64_t tried = 0, failed = 0, undecided = 0;  // triangles
  std::int64_t pixels = 0;                            // covered
  double depth_error = 0;                             // the largest, as a share of what is allowed
  std::vector<std::uint64_t> failures, doubts;        // numbers of the first cases that failed, or were undecided

  Tally& operator+=(const Tally&);
};

/// Cases `first` to `first + count - 1` of a class, on all workers.
Tally run(Class, std::uint64_t seed, std::uint64_t first, std::int64_t count, Workers&, std::vector<Machines>& machines);

}  // namespace tuberia::witness
