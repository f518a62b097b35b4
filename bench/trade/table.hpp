#pragma once
// The table of all switches that trade speed for accuracy. A new technique joins by a row.

#include <functional>
#include <string>
#include <vector>

#include "bench/trade/scene.hpp"

namespace tuberia::bench::trade {

/// One position of a switch.
struct Setting {
  std::string name;
  std::function<void(Recipe&)> apply;
};

/// The first setting is the reference: times are relative to it, and where a scene has no formula for what is right,
/// it is what it draws.
struct Switch {
  std::string name;
  std::vector<Setting> settings;
  std::vector<Scene> scenes;
};

/// Switches whose errors have one unit, and so share a plot.
struct Stage {
  std::string name, title, what;  // one word; a heading; sentences (HTML)
  std::string error_label;        // with its unit
  std::vector<Switch> switches;
};

/// A scene with those switches that matter to it: all combinations of their settings are measured. The reference is
/// all the first ones. The switches' own scenes are not looked at.
struct WholeScene {
  Scene scene;
  std::vector<Switch> switches;
};

std::vector<Stage> all_stages();
std::vector<WholeScene> whole_scenes();

/// Every combination of one setting of each switch; names joined by " + ", the first combination of all the first ones.
/// `choices` of each: the number of the setting of each switch.
struct Combination {
  Setting setting;
  std::vector<std::size_t> choices;
};
std::vector<Combination> combinations(const std::vector<Switch>& switches);

}  // namespace tuberia::bench::trade
