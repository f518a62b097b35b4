#include "bench/frames/frames.hpp"

#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "bench/peers/peer.hpp"
#include "bench/run.hpp"

namespace tuberia::bench {
namespace {

struct Setting {
  int threads = 1;
  InstructionSet isa = best_instruction_set();
  Precision precision = Precision::exact;
  bool operator==(const Setting&) const = default;
};

/// The workload and the renderer that were used last: a benchmark is called several times, and the
/// next one often wants the same workload.
class Stand {
 public:
  Result<Peer*> prepare(const std::string& name, const Setting& setting) {
    if (workload_.name != name) {
      peer_.reset();
      auto made = make_workload(name);
      if (!made) return made.error();
      workload_ = *std::move(made);
    }
    if (peer_ && setting_ == setting) return peer_.get();
    auto made = make_tuberia_peer(setting.threads, setting.isa, setting.precision);
    if (!made) return made.error();
    if (auto prepared = (*made)->prepare(workload_); !prepared) return prepared.error();
    peer_ = *std::move(made);
    setting_ = setting;
    return peer_.get();
  }

  const Workload& workload() const noexcept { return workload_; }

 private:
  Workload workload_;
  Setting setting_;
  std::unique_ptr<Peer> peer_;
};

void draw_frames(benchmark::State& state, Stand& stand, const std::string& name, const Setting& setting) {
  const auto peer = stand.prepare(name, setting);
  if (!peer) return state.SkipWithError(peer.error().message.c_str());
  (*peer)->frame();  // memory is taken and threads are woken
  for (auto _ : state) (*peer)->frame();

  using benchmark::Counter;
  const auto triangles = static_cast<double>(stand.workload().mesh.indices.size() / 3);
  state.counters["frames"] = Counter(1, Counter::kIsIterationInvariantRate);
  if (triangles > 0) state.counters["triangles"] = Counter(triangles, Counter::kIsIterationInvariantRate);
}

std::string threads_name(int threads) { return std::to_string(threads) + (threads == 1 ? "_thread" : "_threads"); }

void add_frame(const std::shared_ptr<Stand>& stand, const std::string& workload, const Setting& setting) {
  const std::string name = benchmark_name("frame", workload, threads_name(setting.threads), name_of(setting.isa), setting.precision);
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { draw_frames(state, *stand, workload, setting); })
      ->MeasureProcessCPUTime()  // of all threads: with the real time it shows whether the machine was ours
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

/// Those that the narrower instruction sets run too: a load on each part of the pipeline.
bool is_for_every_set(const std::string& workload) {
  for (const char* name : {"fill_gouraud", "fill_tex_trilinear", "small_tris", "vertex_bound_lit"})
    if (workload == name) return true;
  return false;
}

}  // namespace

void register_frames() {
  const auto stand = std::make_shared<Stand>();
  for (const std::string& workload : workload_names()) {
    for (const InstructionSet isa : supported_instruction_sets())
      if (isa != best_instruction_set() && is_for_every_set(workload))
        for (const Precision precision : {Precision::exact, Precision::fast})
          add_frame(stand, workload, {.threads = 1, .isa = isa, .precision = precision});
    for (const int threads : {1, 2})
      for (const Precision precision : {Precision::exact, Precision::fast})
        add_frame(stand, workload, {.threads = threads, .isa = best_instruction_set(), .precision = precision});
  }
}

}  // namespace tuberia::bench
