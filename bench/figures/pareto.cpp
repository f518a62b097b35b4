#include "bench/figures/pareto.hpp"

#include <algorithm>
#include <cmath>

namespace tuberia::bench {

std::vector<std::size_t> pareto_front(std::span<const Choice> choices) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (!std::isnan(choices[i].cost) && !std::isnan(choices[i].error)) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return choices[a].cost < choices[b].cost ||
           (choices[a].cost == choices[b].cost && choices[a].error < choices[b].error);
  });
  // By growing cost only the last one kept can dominate the next.
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || !dominates(choices[front.back()], choices[i])) front.push_back(i);
  return front;
}

}  // namespace tuberia::bench
