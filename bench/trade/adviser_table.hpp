#pragma once
// The table that scene/adviser predicts from: its switches, each turned alone, on scenes of each kind of surface.

#include <string>

#include "bench/trade/measure.hpp"
#include "bench/trade/progress.hpp"

namespace tuberia::bench::trade {

/// Measures every setting of every switch on the scenes of each kind and returns the lines that
/// MeasuredTrade::parse reads. circumstances: a line for a person, where and when. Error when a draw is
/// refused.
Result<std::string> measure_adviser_table(const std::string& circumstances, const Effort& effort, const PipelineOptions& pipeline,
                                          const Progress& progress);

}  // namespace tuberia::bench::trade
