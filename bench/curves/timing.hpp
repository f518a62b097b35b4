#pragma once
// Timing one point of a curve.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "bench/figures/statistics.hpp"

namespace tuberia::bench {

/// Seconds that `work` takes: the median of up to seven runs after an untimed one, but no more than
/// about `budget_seconds` in all. What takes longer than that is timed twice, and the shorter counts.
template <class Work>
double seconds_of(Work&& work, double budget_seconds) {
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t kMostRuns = 7;
  const auto timed = [&] {
    const Clock::time_point begin = Clock::now();
    work();
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
  const double first = timed();
  if (first > budget_seconds) return std::min(first, timed());
  std::vector<double> runs;
  for (double spent = 0; runs.size() < kMostRuns && (runs.empty() || spent < budget_seconds); spent += runs.back())
    runs.push_back(timed());
  return median(std::move(runs));
}

/// One line of progress.
inline void tell(const std::string& curve, const std::string& series, double x, double y, const char* unit) {
  std::printf("%-16s %-34s %14g %12.4g %s\n", curve.c_str(), series.c_str(), x, y, unit);
  std::fflush(stdout);
}

}  // namespace tuberia::bench
