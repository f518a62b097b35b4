#pragma once
// What was measured, as scatter plots.

#include "bench/figures/scatter.hpp"
#include "bench/trade/measure.hpp"

namespace tuberia::bench::trade {

/// Every setting of a stage's switches as one point, the mean over its scenes (of times the geometric, of errors the
/// quadratic one); with small points for each scene, if there are several.
Scatter plot_of(const StageResult& stage);

/// All combinations on one scene; the best ones are named. Colours by the switch whose settings differ most in error.
Scatter plot_of(const WholeResult& scene);

/// All scenes: their fronts, each in its colour.
Scatter plot_of(const std::vector<WholeResult>& scenes);

/// Those of the measurements that no other beats in time and error.
std::vector<std::size_t> front_of(const std::vector<Measurement>& measurements);

}  // namespace tuberia::bench::trade
