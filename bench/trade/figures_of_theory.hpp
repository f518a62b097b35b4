#pragma once
// The known figures of each trade [rules 4], beside what theory gives and what was measured here.

#include <optional>
#include <string>
#include <vector>

#include "bench/trade/measure.hpp"

namespace tuberia::bench::trade {

struct KnownFigure {
  std::string stage, what, unit;
  double known = 0;                  // as [rules 4] has it
  std::optional<double> derived{};   // by a closed form here
  std::optional<double> measured{};  // with the machine
  std::string remark{};              // why they differ, or why nothing was measured
};

/// In the order of [rules 4]. What was not measured in this run has no measured figure.
std::vector<KnownFigure> known_figures(const TradeResult& result);

}  // namespace tuberia::bench::trade
