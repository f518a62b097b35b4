// Whole frames of the workloads that the peers are compared on, ours alone: script/bench frames.

#include "bench/frames/frames.hpp"
#include "bench/run.hpp"

int main(int argc, char** argv) {
  tuberia::bench::register_frames();
  return tuberia::bench::run_benchmarks(argc, argv, "0.15");
}
