#pragma once
// What the Google Benchmark programs share: names and the main function.

#include <string>
#include <string_view>

#include "raster/instruction_set.hpp"

namespace tuberia::bench {

/// "stage/what/size/isa/precision". isa may also be "scalar", or what else does the work.
std::string benchmark_name(std::string_view stage, std::string_view what, std::string_view size, std::string_view isa,
                           Precision precision);

/// Runs the registered benchmarks as the command line says; returns the exit status. seconds_each:
/// how long to measure each one unless --benchmark_min_time says otherwise.
int run_benchmarks(int argc, char** argv, std::string_view seconds_each);

}  // namespace tuberia::bench
