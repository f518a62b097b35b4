#include "bench/figures/schedule.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>

#include "base/assertion.hpp"

namespace tuberia::bench {

double makespan(std::span<const double> items, int threads) {
  TUBERIA_ASSERT(threads >= 1, "a loop needs a thread");
  // When each thread becomes free, the earliest on top.
  std::priority_queue<double, std::vector<double>, std::greater<>> free_at(
      std::greater<>{}, std::vector<double>(static_cast<std::size_t>(threads), 0.0));
  double end = 0;
  for (const double item : items) {
    const double done = free_at.top() + item;
    free_at.pop();
    free_at.push(done);
    end = std::max(end, done);
  }
  return end;
}

double Work::total() const {
  double sum = alone;
  for (const Loop& loop : loops) sum = std::accumulate(loop.begin(), loop.end(), sum);
  return sum;
}

double Work::longest_chain() const {
  double sum = alone;
  for (const Loop& loop : loops)
    if (!loop.empty()) sum += *std::max_element(loop.begin(), loop.end());
  return sum;
}

double Work::duration(int threads) const {
  double sum = alone;
  for (const Loop& loop : loops) sum += makespan(loop, threads);
  return sum;
}

}  // namespace tuberia::bench
