#pragma once
// The benchmarks of the stages, a function for each file of them, and how they register. A floor is
// a copy of as many bytes as the stage has to write: no way of writing them takes less time.

#include <benchmark/benchmark.h>

#include <string_view>

#include "bench/run.hpp"

namespace tuberia::bench {

void register_fetch_and_assembly();
void register_vertex_transform();
void register_clipping();
void register_divide_and_culling();
void register_set_up_and_binning();
void register_rasterization();
void register_depth_test();
void register_fragment_shading();
void register_blending();

/// body(state), for a stage without kernels.
template <class Body>
void add_scalar(std::string_view stage, std::string_view what, std::string_view size, Body body) {
  benchmark::RegisterBenchmark(benchmark_name(stage, what, size, "scalar", Precision::exact).c_str(), body);
}

/// body(state, instruction set), for an exact stage.
template <class Body>
void add_exact(std::string_view stage, std::string_view what, std::string_view size, Body body) {
  for (const InstructionSet isa : supported_instruction_sets())
    benchmark::RegisterBenchmark(benchmark_name(stage, what, size, name_of(isa), Precision::exact).c_str(),
                                 [=](benchmark::State& state) { body(state, isa); });
}

/// body(state, instruction set, precision).
template <class Body>
void add_both_precisions(std::string_view stage, std::string_view what, std::string_view size, Body body) {
  for (const InstructionSet isa : supported_instruction_sets())
    for (const Precision precision : {Precision::exact, Precision::fast})
      benchmark::RegisterBenchmark(benchmark_name(stage, what, size, name_of(isa), precision).c_str(),
                                   [=](benchmark::State& state) { body(state, isa, precision); });
}

/// Copies `items` times `bytes_each` with the C library; named <what>_floor, isa memcpy.
void add_floor(std::string_view stage, std::string_view what, std::string_view size, std::size_t items, std::size_t bytes_each);

/// Sets the rate, items a second, where one iteration worked on `items`.
void set_rate(benchmark::State& state, std::size_t items);

}  // namespace tuberia::bench
