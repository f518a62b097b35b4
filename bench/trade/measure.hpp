#pragma once
// Both sides of a trade, measured on one scene.

#include <string>
#include <vector>

#include "bench/trade/table.hpp"
#include "bench/figures/timing.hpp"

namespace tuberia::bench::trade {

/// One setting on one scene.
struct Measurement {
  std::string setting;
  RelativeTime time;        // against the first setting
  double error = 0;         // in the unit of the stage; against what the picture should be
  PictureError to_ideal{};  // only of scenes that are pictures
  CodeError to_reference{};
  float middle = 0;                    // red in the middle of the picture
  std::vector<std::size_t> choices{};  // of whole scenes: the number of the setting of each switch
};

/// Draws the scene with every setting, timed in turns. The first is the reference. Error when a draw is refused.
Result<std::vector<Measurement>> measure(const Scene& scene, const std::vector<Setting>& settings, const Effort& effort,
                                         const PipelineOptions& pipeline);

/// The scene with one setting, as a screen shows it.
Result<Image<Rgba8>> screen_picture(const Scene& scene, const Setting& setting, const PipelineOptions& pipeline);

/// What was measured of one switch on one scene.
struct SwitchResult {
  std::string switch_name, scene, what;
  bool is_picture = true;
  std::vector<Measurement> measurements;
};

struct StageResult {
  std::string name, title, what, error_label;
  std::vector<SwitchResult> switches;
};

struct WholeResult {
  std::string scene, what;
  std::string picture_file;                        // of the reference, beside the page; empty: none
  std::vector<std::string> switches;               // names
  std::vector<std::vector<std::string>> settings;  // names, of each switch
  std::vector<Measurement> measurements;
};

struct TradeResult {
  std::vector<StageResult> stages;
  std::vector<WholeResult> scenes;
};

}  // namespace tuberia::bench::trade
