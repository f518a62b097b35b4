#include "bench/trade/plots.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "bench/figures/page.hpp"
#include "bench/figures/pareto.hpp"
#include "bench/figures/statistics.hpp"

namespace tuberia::bench::trade {
namespace {

constexpr double kNegligible = 1e-3;  // of codes, texels, wrong pixels per 1000 px, percent

constexpr const char* kTimeLabel = "time, relative to the reference (ring)";

std::string hover_text(const std::string& scene, const Measurement& measurement) {
  return scene + ", " + measurement.setting + ": time x " + number_text(measurement.time.ratio) + ", error " +
         number_text(measurement.error);
}

/// The points of one switch: its settings over all scenes that it was measured on.
void add_switch(Scatter& plot, const std::vector<const SwitchResult*>& scenes, std::size_t group,
                std::set<std::string>& named) {
  const std::size_t settings = scenes.front()->measurements.size();
  for (std::size_t i = 0; i < settings; ++i) {
    std::vector<double> ratios;
    double squares = 0;
    for (const SwitchResult* scene : scenes) {
      const Measurement& each = scene->measurements[i];
      ratios.push_back(each.time.ratio);
      squares += each.error * each.error;
      if (scenes.size() > 1)
        plot.points.push_back({.x = each.time.ratio,
                               .y = each.error,
                               .group = group,
                               .is_detail = true,
                               .hover = hover_text(scene->scene, each)});
    }
    const std::string& name = scenes.front()->measurements[i].setting;
    const double error = std::sqrt(squares / static_cast<double>(scenes.size())), ratio = geometric_mean(ratios);
    // Two switches may share their reference, which need not be named twice.
    plot.points.push_back({.x = ratio,
                           .y = error,
                           .label = named.insert(name).second ? name : "",
                           .group = group,
                           .is_reference = i == 0,
                           .hover = name + ": time x " + number_text(ratio) + ", error " + number_text(error)});
  }
}

/// Of which switch the settings differ most: the spread of the mean errors.
std::size_t most_telling_switch(const WholeResult& result) {
  std::size_t best = 0;
  double most = -1;
  for (std::size_t each = 0; each < result.switches.size(); ++each) {
    std::vector<double> sums(result.settings[each].size(), 0), counts(sums.size(), 0);
    for (const Measurement& measurement : result.measurements) {
      sums[measurement.choices[each]] += measurement.error;
      ++counts[measurement.choices[each]];
    }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
    const auto [low, high] = std::minmax_element(sums.begin(), sums.end());
    if (*high - *low > most) {
      most = *high - *low;
      best = each;
    }
  }
  return best;
}

/// Without the settings that are the reference's own.
std::string short_name(const WholeResult& result, const Measurement& measurement) {
  std::string name;
  for (std::size_t i = 0; i < measurement.choices.size(); ++i)
    if (measurement.choices[i] != 0) name += (name.empty() ? "" : " + ") + result.settings[i][measurement.choices[i]];
  return name.empty() ? "reference" : name;
}

/// Whether all switches were measured on the same scenes, so that one front makes sense.
bool have_one_scene(const StageResult& stage) {
  std::map<std::string, std::set<std::string>> scenes;
  for (const SwitchResult& each : stage.switches) scenes[each.switch_name].insert(each.scene);
  return std::all_of(scenes.begin(), scenes.end(),
                     [&](const auto& each) { return each.second == scenes.begin()->second; });
}

}  // namespace

std::vector<std::size_t> front_of(const std::vector<Measurement>& measurements) {
  std::vector<Choice> choices;
  for (const Measurement& each : measurements) choices.push_back({each.time.ratio, each.error});
  return pareto_front(choices);
}

Scatter plot_of(const StageResult& stage) {
  Scatter plot{.x = {kTimeLabel}, .y = {stage.error_label}, .groups = {}, .points = {}, .negligible = kNegligible};
  std::set<std::string> named;
  for (std::size_t i = 0; i < stage.switches.size();) {
    std::vector<const SwitchResult*> scenes;
    const std::string& name = stage.switches[i].switch_name;
    for (; i < stage.switches.size() && stage.switches[i].switch_name == name; ++i)
      scenes.push_back(&stage.switches[i]);
    add_switch(plot, scenes, plot.groups.size(), named);
    plot.groups.push_back(name);
  }
  plot.front_of_each_group = !have_one_scene(stage);
  return plot;
}

Scatter plot_of(const WholeResult& result) {
  const std::size_t telling = most_telling_switch(result);
  Scatter plot{.x = {kTimeLabel}, .y = {"RMSE, codes of 255"}, .groups = result.settings[telling], .points = {}};
  const std::vector<std::size_t> front = front_of(result.measurements);
  for (std::size_t i = 0; i < result.measurements.size(); ++i) {
    const Measurement& each = result.measurements[i];
    const bool is_named = i == 0 || std::find(front.begin(), front.end(), i) != front.end();
    plot.points.push_back({.x = each.time.ratio,
                           .y = each.error,
                           .label = is_named ? short_name(result, each) : "",
                           .group = each.choices[telling],
                           .is_reference = i == 0,
                           .hover = hover_text(result.scene, each)});
  }
  return plot;
}

Scatter plot_of(const std::vector<WholeResult>& scenes) {
  Scatter plot{.x = {kTimeLabel}, .y = {"RMSE, codes of 255"}, .groups = {}, .points = {}, .front_of_each_group = true};
  for (const WholeResult& result : scenes) {
    const std::vector<std::size_t> front = front_of(result.measurements);
    for (std::size_t i = 0; i < result.measurements.size(); ++i) {
      const Measurement& each = result.measurements[i];
      const bool is_best = std::find(front.begin(), front.end(), i) != front.end();
      plot.points.push_back({.x = each.time.ratio,
                             .y = each.error,
                             .label = i == front.front() ? result.scene : "",
                             .group = plot.groups.size(),
                             .is_reference = i == 0,
                             .is_detail = !is_best && i != 0,
                             .hover = hover_text(result.scene, each)});
    }
    plot.groups.push_back(result.scene);
  }
  return plot;
}

}  // namespace tuberia::bench::trade
