#pragma once
// The order in which the adviser tries qualities.

#include <cstddef>
#include <functional>
#include <vector>

#include "base/result.hpp"
#include "scene/adviser/quality.hpp"

namespace tuberia {

/// What was measured of other scenes, per quality.
struct Prospect {
  Quality quality;
  double cost = 0;     // to be made small: time, or error; as predicted
  double burden = 0;   // what the budget limits, as a part of it, as predicted: up to 1 is allowed
};

/// What came of trying one.
struct Outcome {
  double cost = 0, burden = 0;
};

struct SearchResult {
  std::vector<std::size_t> tried;     // numbers of prospects, in order
  std::size_t chosen = 0;             // number of a prospect
  bool keeps_budget = false;          // whether the chosen one's outcome does
  int broken_predictions = 0;         // tried for their prediction, and too much a burden
};

using IsWorse = std::function<bool(const Quality&, const Quality&)>;
using Attempt = std::function<Result<Outcome>(const Quality&)>;

/// Tries the cheapest prospect that the prediction allows. While it proves too much, predictions are
/// corrected by what was found and the next one is tried. When one keeps the budget, those that should be
/// cheaper still are tried, too, the least burden first. `is_worse(a, b)`: if a was too much a burden, b is as
/// well. Error as soon as a trial has one.
Result<SearchResult> search(const std::vector<Prospect>& prospects, const IsWorse& is_worse, const Attempt& attempt);

}  // namespace tuberia
