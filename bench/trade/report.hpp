#pragma once
// What was measured, for programs and for people.

#include <string>

#include "bench/figures/machine.hpp"
#include "bench/figures/page.hpp"
#include "bench/trade/figures_of_theory.hpp"
#include "bench/trade/measure.hpp"

namespace tuberia::bench::trade {

/// What the figures are about.
struct Circumstances {
  Machine machine{};
  PipelineOptions pipeline{};
  bool is_quick = false;
};

/// One line a setting on a scene, with a heading.
std::string csv_of(const TradeResult& result);

/// Everything, with the known figures.
std::string json_of(const TradeResult& result, const Circumstances& circumstances);

/// Tables: every stage, the best combinations of every scene, the known figures.
std::string markdown_of(const TradeResult& result, const Circumstances& circumstances);

Page page_of(const TradeResult& result, const Circumstances& circumstances);

}  // namespace tuberia::bench::trade
