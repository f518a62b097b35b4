#include "scene/adviser/search.hpp"

#include <algorithm>
#include <optional>

namespace tuberia {
namespace {

// Predictions come from other scenes: one that is this much too high is still worth a look, and so many
// looks are worth their time.
constexpr double kHope = 20;
constexpr int kMostLooks = 24;
// What should cost so much of the best so far, or less.
constexpr double kWorthALook = 0.95;

class Search {
 public:
  Search(const std::vector<Prospect>& prospects, const IsWorse& is_worse, const Attempt& attempt)
      : prospects_(prospects), is_worse_(is_worse), attempt_(attempt), outcomes_(prospects.size()) {
    for (std::size_t i = 0; i < prospects.size(); ++i) by_cost_.push_back(i);
    std::sort(by_cost_.begin(), by_cost_.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(prospects[a].cost, prospects[a].burden) < std::pair(prospects[b].cost, prospects[b].burden);
    });
  }

  Result<SearchResult> run() {
    if (const auto found = as_predicted(); !found) return found.error();
    if (best_)
      if (const auto looked = cheaper_than_predicted(); !looked) return looked.error();
    result_.keeps_budget = best_.has_value();
    result_.chosen = best_ ? *best_ : least_burden();
    return result_;
  }

 private:
  Result<Nothing> as_predicted() {
    double correction = 1;
    while (!best_) {
      const auto next = std::find_if(by_cost_.begin(), by_cost_.end(), [&](std::size_t i) {
        return is_open(i) && prospects_[i].burden * correction <= 1;
      });
      if (next == by_cost_.end()) return result_.tried.empty() ? attempt(least_predicted_burden()) : Nothing{};
      if (const auto tried = attempt(*next); !tried) return tried.error();
      if (best_) return Nothing{};
      ++result_.broken_predictions;
      if (prospects_[*next].burden > 0) correction = std::max(correction, outcomes_[*next]->burden / prospects_[*next].burden);
    }
    return Nothing{};
  }

  Result<Nothing> cheaper_than_predicted() {
    for (int looks = 0; looks < kMostLooks; ++looks) {
      std::optional<std::size_t> next;
      for (const std::size_t i : by_cost_) {
        if (prospects_[i].cost > prospects_[*best_].cost * kWorthALook) break;
        if (is_open(i) && prospects_[i].burden <= kHope && (!next || prospects_[i].burden < prospects_[*next].burden)) next = i;
      }
      if (!next) break;
      if (const auto tried = attempt(*next); !tried) return tried.error();
    }
    return Nothing{};
  }

  Result<Nothing> attempt(std::size_t i) {
    const auto outcome = attempt_(prospects_[i].quality);
    if (!outcome) return outcome.error();
    outcomes_[i] = *outcome;
    result_.tried.push_back(i);
    if (outcome->burden <= 1 && (!best_ || outcome->cost < outcomes_[*best_]->cost)) best_ = i;
    return Nothing{};
  }

  /// Neither tried nor bound to fail.
  bool is_open(std::size_t i) const {
    if (outcomes_[i]) return false;
    return std::none_of(result_.tried.begin(), result_.tried.end(), [&](std::size_t k) {
      return outcomes_[k]->burden > 1 && is_worse_(prospects_[k].quality, prospects_[i].quality);
    });
  }

  std::size_t least_predicted_burden() const {
    const auto least = std::min_element(prospects_.begin(), prospects_.end(),
                                        [](const Prospect& a, const Prospect& b) { return a.burden < b.burden; });
    return static_cast<std::size_t>(least - prospects_.begin());
  }

  std::size_t least_burden() const {
    return *std::min_element(result_.tried.begin(), result_.tried.end(),
                             [&](std::size_t a, std::size_t b) { return outcomes_[a]->burden < outcomes_[b]->burden; });
  }

  const std::vector<Prospect>& prospects_;
  const IsWorse& is_worse_;
  const Attempt& attempt_;
  std::vector<std::optional<Outcome>> outcomes_;
  std::vector<std::size_t> by_cost_;
  std::optional<std::size_t> best_;
  SearchResult result_;
};

}  // namespace

Result<SearchResult> search(const std::vector<Prospect>& prospects, const IsWorse& is_worse, const Attempt& attempt) {
  TUBERIA_ASSERT(!prospects.empty(), "there is always the reference");
  return Search(prospects, is_worse, attempt).run();
}

}  // namespace tuberia
