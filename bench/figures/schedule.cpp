#include "bench/figures/schedule.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

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
  for (const Loop& loop : loops_of(1)) sum = std::accumulate(loop.begin(), loop.end(), sum);
  return sum;
}

double Work::duration(int threads) const {
  double sum = alone;
  for (const Loop& loop : loops_of(threads)) sum += makespan(loop, threads);
  return sum;
}

double Work::longest_chain(int threads) const {
  double sum = alone;
  for (const Loop& loop : loops_of(threads))
    if (!loop.empty()) sum += *std::max_element(loop.begin(), loop.end());
  return sum;
}

std::vector<Loop> Work::loops_of(int threads) const {
  std::vector<Loop> all = loops;
  for (const std::vector<Batch>& draw : draws)
    for (std::size_t first = 0; first < draw.size(); first += static_cast<std::size_t>(threads)) {
      Batch joined = draw[first];
      const std::size_t end = std::min(draw.size(), first + static_cast<std::size_t>(threads));
      for (std::size_t i = first + 1; i < end; ++i) {
        joined.chunks.insert(joined.chunks.end(), draw[i].chunks.begin(), draw[i].chunks.end());
        std::transform(joined.tiles.begin(), joined.tiles.end(), draw[i].tiles.begin(), joined.tiles.begin(), std::plus<>{});
      }
      all.push_back(std::move(joined.chunks));
      all.push_back(std::move(joined.tiles));
    }
  return all;
}

}  // namespace tuberia::bench
