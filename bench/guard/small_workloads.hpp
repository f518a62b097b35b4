#pragma once
// Eight small frames, each a load on another part of the pipeline: small enough to be counted
// instruction by instruction.

#include <string>
#include <vector>

#include "bench/peers/workloads.hpp"

namespace tuberia::bench {

std::vector<std::string> small_workload_names();

/// Error for an unknown name.
Result<Workload> make_small_workload(std::string_view name);

}  // namespace tuberia::bench
