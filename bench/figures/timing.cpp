#include "bench/figures/timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "bench/figures/statistics.hpp"

namespace tuberia::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kShortestTiming = 1.5e-3;  // seconds
constexpr int kMostRuns = 200;

/// Seconds from some beginning.
double now(bool of_processor) {
  if (of_processor) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

double seconds_a_run(const std::function<void()>& way, int runs, bool of_processor) {
  if (runs > 1) way();
  const double begin = now(of_processor);
  for (int i = 0; i < runs; ++i) way();
  return (now(of_processor) - begin) / runs;
}

std::vector<int> runs_of_each(std::span<const std::function<void()>> ways, bool of_processor) {
  std::vector<int> runs;
  for (const std::function<void()>& way : ways) {
    way();
    const double seconds = std::max(seconds_a_run(way, 1, of_processor), kShortestTiming / kMostRuns);
    runs.push_back(std::clamp(static_cast<int>(std::ceil(kShortestTiming / seconds)), 1, kMostRuns));
  }
  return runs;
}

RelativeTime summary(const std::vector<double>& times, const std::vector<double>& of_first) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < times.size(); ++i) ratios.push_back(times[i] / of_first[i]);
  return {.median_ms = 1e3 * median(times),
          .ratio = median(ratios),
          .lower_quartile = quantile(ratios, 0.25),
          .upper_quartile = quantile(ratios, 0.75),
          .rounds = static_cast<int>(times.size())};
}

}  // namespace

std::vector<RelativeTime> time_in_turns(std::span<const std::function<void()>> ways, const Effort& effort) {
  const std::vector<int> runs = runs_of_each(ways, effort.of_processor);
  std::vector<std::vector<double>> times(ways.size());
  const double begin = now(false);
  for (int round = 0; round < effort.fewest_rounds || now(false) - begin < effort.seconds; ++round)
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const std::size_t way = round % 2 == 0 ? i : ways.size() - 1 - i;
      times[way].push_back(seconds_a_run(ways[way], runs[way], effort.of_processor));
    }
  std::vector<RelativeTime> all;
  for (const std::vector<double>& each : times) all.push_back(summary(each, times.front()));
  return all;
}

}  // namespace tuberia::bench
