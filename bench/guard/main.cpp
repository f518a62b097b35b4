// Fails when a frame costs more instructions than it used to: script/bench check.

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "base/parallel_for.hpp"
#include "bench/figures/command_line.hpp"
#include "bench/guard/baseline.hpp"
#include "bench/guard/counting.hpp"
#include "bench/guard/small_workloads.hpp"
#include "raster/instruction_set.hpp"

namespace tuberia::bench {
namespace {

struct Options {
  std::string baseline_file = "bench/guard/baseline.txt", drawn;
  bool record = false;
};

int fail(const std::string& message) {
  std::fprintf(stderr, "script/bench check: %s\n", message.c_str());
  return 1;
}

std::string this_compiler() {
#if defined(__clang__)
  return std::string("clang++ ") + __clang_version__;
#else
  return std::string("g++ ") + __VERSION__;
#endif
}

void add_options(CommandLine& line, Options& options) {
  line.text("--baseline", options.baseline_file, "The recorded counts");
  line.flag("--record", options.record, "Write the counts to the baseline instead of comparing");
  line.text("--draw", options.drawn, "Only draw this workload: what runs under valgrind");
  line.exclude("--draw", "--record");
}

Result<std::vector<InstructionCount>> count_all() {
  const ScratchFolder scratch;
  const std::vector<std::string> names = small_workload_names();
  std::vector<std::optional<Result<std::int64_t>>> counts(names.size());
  Workers workers;
  parallel_for(workers, static_cast<std::int64_t>(names.size()), [&](std::int64_t item, int) {
    const auto i = static_cast<std::size_t>(item);
    counts[i] = count_instructions(names[i], scratch);
  });
  std::vector<InstructionCount> all;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!*counts[i]) return counts[i]->error();
    all.push_back({names[i], counts[i]->value()});
  }
  return all;
}

int record(const std::string& path, const std::vector<InstructionCount>& counts) {
  std::ofstream file(path);
  file << text_of({.compiler = this_compiler(), .counts = counts});
  file.close();
  if (!file) return fail("cannot write " + path);
  std::printf("Recorded in %s.\n", path.c_str());
  return 0;
}

int report(const Baseline& baseline, const std::vector<InstructionCount>& counts) {
  const std::vector<Comparison> comparisons = compare(baseline.counts, counts);
  std::printf("%s\n", table_of(comparisons).c_str());
  const bool passed = passes(comparisons);
  if (baseline.compiler != this_compiler()) {
    std::printf("Only for your information: recorded with %s,\nbuilt with %s, which counts differently.\n",
                baseline.compiler.c_str(), this_compiler().c_str());
    return 0;
  }
  const bool better = std::any_of(comparisons.begin(), comparisons.end(),
                                  [](const Comparison& each) { return each.verdict == Verdict::better; });
  if (!passed)
    std::printf(
        "More than %g %% above the recorded count, or not on both sides. If there is a good reason, record it.\n",
        kTolerancePercent);
  else std::printf("No frame costs over %g %% more than recorded.\n", kTolerancePercent);
  if (!passed || better) std::printf("To record: script/bench check --record\n");
  return passed ? 0 : 1;
}

int check(const Options& options) {
  if (!is_supported(InstructionSet::avx2)) {
    std::printf("Nothing is compared: the counts are of AVX2, which this machine does not have.\n");
    return 0;
  }
  if (!options.drawn.empty()) {
    const auto drawn = draw_counted_frame(options.drawn);
    return drawn ? 0 : fail(drawn.error().message);
  }
  std::optional<Baseline> baseline;
  if (!options.record) {
    std::ifstream file(options.baseline_file);
    if (!file) return fail("cannot open " + options.baseline_file + "; script/bench check --record writes one");
    std::ostringstream text;
    text << file.rdbuf();
    auto parsed = parse_baseline(text.str(), options.baseline_file);
    if (!parsed) return fail(parsed.error().message);
    baseline = *std::move(parsed);
  }
  const auto counts = count_all();
  if (!counts) return fail(counts.error().message);
  return options.record ? record(options.baseline_file, *counts) : report(*baseline, *counts);
}

}  // namespace
}  // namespace tuberia::bench

int main(int argc, char** argv) {
  tuberia::bench::CommandLine line("Counts the instructions of eight small frames and compares them with recorded counts.", "tuberia_check");
  tuberia::bench::Options options;
  tuberia::bench::add_options(line, options);
  if (const auto status = line.parse(argc, argv)) return *status;
  return tuberia::bench::check(options);
}
