#include "bench/run.hpp"

#include <benchmark/benchmark.h>

#include <vector>

namespace tuberia::bench {

std::string benchmark_name(std::string_view stage, std::string_view what, std::string_view size, std::string_view isa,
                           Precision precision) {
  std::string name;
  for (const std::string_view part : {stage, what, size, isa, name_of(precision)}) {
    if (!name.empty()) name += '/';
    name += part;
  }
  return name;
}

int run_benchmarks(int argc, char** argv, std::string_view seconds_each) {
  // Of two options of one name the later one counts, so ours goes before the user's.
  std::string min_time = "--benchmark_min_time=" + std::string(seconds_each);
  std::vector<char*> arguments(argv, argv + argc);
  arguments.insert(arguments.begin() + (argc > 0 ? 1 : 0), min_time.data());
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);

  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace tuberia::bench
