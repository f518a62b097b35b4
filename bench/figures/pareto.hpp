#pragma once
// Which of several choices nobody would regret.

#include <cstddef>
#include <span>
#include <vector>

namespace tuberia::bench {

/// What one choice costs, and what is wrong with what it gives; less is better of both.
struct Choice {
  double cost = 0, error = 0;
};

/// Whether the first is at least as good in both and better in one.
constexpr bool dominates(const Choice& first, const Choice& second) noexcept {
  return first.cost <= second.cost && first.error <= second.error &&
         (first.cost < second.cost || first.error < second.error);
}

/// The places of those choices that no other dominates, by growing cost (and so by falling error). Equal
/// ones are all there, in their order. A choice with a cost or error that is not a number is never there.
std::vector<std::size_t> pareto_front(std::span<const Choice> choices);

}  // namespace tuberia::bench
