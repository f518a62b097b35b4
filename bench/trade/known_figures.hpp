#pragma once
// The parts of the list of known figures.

#include "bench/trade/figures_of_theory.hpp"

namespace tuberia::bench::trade {

/// Looks up what was measured; scenes and settings by how their names begin.
class Measured {
 public:
  explicit Measured(const TradeResult& result) : result_(result) {}

  const Measurement* find(const std::string& stage, const std::string& switch_name, const std::string& scene,
                          const std::string& setting) const {
    for (const StageResult& each : result_.stages)
      if (each.name == stage)
        for (const SwitchResult& result : each.switches)
          if (result.switch_name == switch_name && result.scene == scene)
            for (const Measurement& measurement : result.measurements)
              if (measurement.setting == setting) return &measurement;
    return nullptr;
  }

  std::optional<double> error(const std::string& stage, const std::string& switch_name, const std::string& scene,
                              const std::string& setting, double scale = 1) const {
    const Measurement* found = find(stage, switch_name, scene, setting);
    return found == nullptr ? std::nullopt : std::optional(found->error * scale);
  }

 private:
  const TradeResult& result_;
};

using Figures = std::vector<KnownFigure>;

// Each appends its rows of [rules 4].
void add_subpixel_bits(Figures& figures, const Measured& measured);
void add_edge_arithmetic(Figures& figures, const Measured& measured);
void add_perspective(Figures& figures, const Measured& measured);
void add_filters(Figures& figures, const Measured& measured);
void add_edges(Figures& figures, const Measured& measured);
void add_shading(Figures& figures, const Measured& measured);
void add_approximations(Figures& figures);
void add_targets(Figures& figures, const Measured& measured);
void add_depth(Figures& figures, const Measured& measured);
void add_footprints(Figures& figures);

}  // namespace tuberia::bench::trade
