// tuberia_verify: random scenes on both machines, as many as asked for. Exit status 1 when they
// disagree where no tie explains it.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "base/parallel_for.hpp"
#include "tests/differential/comparison.hpp"
#include "tests/differential/shrinking.hpp"

namespace {

using namespace tuberia;
using namespace tuberia::differential;

struct Options {
  std::int64_t states = 10000;
  std::uint64_t seed = 1;
  int threads = 0;
};

void print_usage() {
  std::puts("usage: tuberia_verify [--states N] [--seed S] [--threads T]\n"
            "Draws N random scenes, those of the seeds S to S + N - 1, with the pipeline and with the\n"
            "scalar oracle, and compares every sample. T threads; 0 takes one a core.");
}

bool parse(int count, char** arguments, Options& options) {
  for (int i = 1; i < count; i += 2) {
    const std::string_view name = arguments[i];
    char* end = nullptr;
    if (i + 1 == count) return false;
    const unsigned long long value = std::strtoull(arguments[i + 1], &end, 10);
    if (*end != '\0' || end == arguments[i + 1]) return false;
    if (name == "--states") options.states = static_cast<std::int64_t>(value);
    else if (name == "--seed") options.seed = value;
    else if (name == "--threads") options.threads = static_cast<int>(value);
    else return false;
  }
  return options.states > 0;
}

/// One line that is written over again.
void print_progress(std::int64_t done, std::int64_t all, double seconds, std::int64_t disagreements) {
  const double rate = static_cast<double>(done) / std::max(seconds, 1e-9);
  const double left = static_cast<double>(all - done) / std::max(rate, 1e-9);
  std::printf("\r%lld of %lld states, %.0f a second, %.0f min %02.0f s left, %lld disagreements ", static_cast<long long>(done),
              static_cast<long long>(all), rate, std::floor(left / 60), std::floor(std::fmod(left, 60)), static_cast<long long>(disagreements));
  std::fflush(stdout);
}

double percent(std::int64_t part, std::int64_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

void print_summary(const Tally& t) {
  const auto n = [](std::int64_t x) { return static_cast<long long>(x); };
  std::printf("\n%lld states, %lld draws, %lld fragments; %lld samples compared\n", n(t.states), n(t.draws), n(t.fragments), n(t.samples));
  std::printf("ties: %lld of %lld drawn channels (%.4f %%) lie too near to one to be sure of the last digit;\n"
              "      %lld samples (%.4f %%) depend on a test of a colour at a tie\n",
              n(t.tied_channels), n(t.drawn_channels), percent(t.tied_channels, t.drawn_channels), n(t.uncertain_samples),
              percent(t.uncertain_samples, t.samples));
  const auto law = [&](const char* what, std::int64_t tried, std::int64_t failed) {
    std::printf("law: random scenes, %-16s tried %11lld  failed %lld\n", what, n(tried), n(failed));
  };
  law("colour", t.samples - t.uncertain_samples, t.colour);
  law("depth codes", t.samples - t.uncertain_samples, t.depth);
  law("stencil codes", t.samples - t.uncertain_samples, t.stencil);
  law("counts", t.draws, t.counts);
  law("draws accepted", t.draws, t.refusals);
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  if (!parse(count, arguments, options)) {
    print_usage();
    return 2;
  }
  Workers workers(options.threads);
  const auto threads = static_cast<std::size_t>(workers.thread_count());
  std::vector<Machines> machines(threads);
  constexpr std::int64_t kBatch = 256;
  constexpr int kToldFailures = 5;
  int told = 0;
  Tally total;
  const auto start = std::chrono::steady_clock::now();
  for (std::int64_t begin = 0; begin < options.states; begin += kBatch) {
    const std::int64_t size = std::min(kBatch, options.states - begin);
    std::vector<Tally> tallies(static_cast<std::size_t>(size));
    const auto seed_of = [&](std::int64_t i) { return options.seed + static_cast<std::uint64_t>(begin + i); };
    parallel_for(workers, size, [&](std::int64_t i, int worker) {
      std::string first;
      tallies[static_cast<std::size_t>(i)] = compare(random_scene(seed_of(i)), machines[static_cast<std::size_t>(worker)], first);
    });
    for (std::int64_t i = 0; i < size; ++i) {
      total += tallies[static_cast<std::size_t>(i)];
      if (tallies[static_cast<std::size_t>(i)].disagreements() > 0 && told++ < kToldFailures)
        std::printf("\nseed %llu\n%s\n", static_cast<unsigned long long>(seed_of(i)), explained(random_scene(seed_of(i)), machines[0]).c_str());
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    print_progress(begin + size, options.states, elapsed.count(), total.disagreements());
  }
  print_summary(total);
  return total.disagreements() == 0 ? 0 : 1;
}
