#include "bench/peers/comparison.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

namespace tuberia::bench {

namespace {

constexpr int kFewestPairs = 7;

double milliseconds_of_a_frame(Peer& peer) {
  using Clock = std::chrono::steady_clock;
  peer.frame();
  const Clock::time_point begin = Clock::now();
  peer.frame();
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace

Timing time_in_turns(const Workload& workload, Peer& first, Peer& second, double seconds) {
  std::vector<double> first_ms, second_ms, ratios;
  double first_total_ms = 0, second_total_ms = 0;
  while (static_cast<int>(ratios.size()) < kFewestPairs || std::max(first_total_ms, second_total_ms) < 1e3 * seconds) {
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
          .pairs = static_cast<int>(ratios.size())};
}

}  // namespace tuberia::bench
