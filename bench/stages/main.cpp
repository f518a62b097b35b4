// Each stage of the pipeline alone, on one thread: script/bench stages.

#include <cstring>
#include <string>
#include <vector>

#include "bench/stages/stages.hpp"

namespace tuberia::bench {

void add_floor(std::string_view stage, std::string_view what, std::string_view size, std::size_t items, std::size_t bytes_each) {
  const std::string name = benchmark_name(stage, std::string(what) + "_floor", size, "memcpy", Precision::exact);
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    const std::vector<char> from(items * bytes_each, 1);
    std::vector<char> to(from.size());
    for (auto _ : state) {
      std::memcpy(to.data(), from.data(), from.size());
      benchmark::DoNotOptimize(to.data());
      benchmark::ClobberMemory();
    }
    set_rate(state, items);
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(from.size()));
  });
}

void set_rate(benchmark::State& state, std::size_t items) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items));
}

}  // namespace tuberia::bench

int main(int argc, char** argv) {
  using namespace tuberia::bench;
  register_fetch_and_assembly();
  register_vertex_transform();
  register_clipping();
  register_divide_and_culling();
  register_set_up_and_binning();
  register_rasterization();
  register_fragment_shading();
  register_depth_test();
  register_blending();
  return run_benchmarks(argc, argv, "0.1");
}
