#include "bench/peers/comparison.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

#include "bench/figures/statistics.hpp"

namespace tuberia::bench {

namespace {

double milliseconds_of_a_frame(Peer& peer) {
  using Clock = std::chrono::steady_clock;
  peer.frame();
  const Clock::time_point begin = Clock::now();
  peer.frame();
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

}  // namespace

Timing time_in_turns(const Workload& workload, Peer& first, Peer& second, double seconds, int fewest_rounds) {
  std::vector<double> first_ms, second_ms, ratios;
  double first_total_ms = 0, second_total_ms = 0;
  while (static_cast<int>(ratios.size()) < fewest_rounds || std::max(first_total_ms, second_total_ms) < 1e3 * seconds) {
    const bool first_begins = ratios.size() % 2 == 0;
    if (first_begins) first_ms.push_back(milliseconds_of_a_frame(first));
    second_ms.push_back(milliseconds_of_a_frame(second));
    if (!first_begins) first_ms.push_back(milliseconds_of_a_frame(first));
    first_total_ms += first_ms.back();
    second_total_ms += second_ms.back();
    ratios.push_back(second_ms.back() / first_ms.back());
  }
  return {.workload = workload.name,
          .first_median_ms = median(first_ms),
          .first_smallest_ms = *std::min_element(first_ms.begin(), first_ms.end()),
          .second_median_ms = median(second_ms),
          .second_smallest_ms = *std::min_element(second_ms.begin(), second_ms.end()),
          .ratio = median(ratios),
          .lower_quartile = quantile(ratios, 0.25),
          .upper_quartile = quantile(ratios, 0.75),
          .rounds = static_cast<int>(ratios.size())};
}

}  // namespace tuberia::bench
