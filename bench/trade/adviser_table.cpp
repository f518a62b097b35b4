#include "bench/trade/adviser_table.hpp"

#include <cmath>
#include <cstdio>

#include "bench/trade/scenes.hpp"
#include "scene/adviser/measured_trade.hpp"

namespace tuberia::bench::trade {
namespace {

std::vector<Scene> scenes_of(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::textured: return {against_reference(floor_scene())};
    case SurfaceKind::textured_lit: return {against_reference(relief_scene())};
    case SurfaceKind::lit: break;
  }
  return {against_reference(model()), against_reference(spheres())};
}

/// The adviser's setting for a recipe. Its reference is applied first, which is not always the recipe's own.
Setting setting_of(const Quality& quality) {
  return {words_of(quality), [quality](Recipe& recipe) {
            QualityState state;
            state.view.sampler = recipe.sampler;
            state.view.rasterization = recipe.state.rasterization;
            state = with_quality(state, quality);
            recipe.sampler = state.view.sampler;
            recipe.state.rasterization = state.view.rasterization;
            recipe.shading = state.view.lit_at_vertices ? Shading::gouraud : Shading::phong;
            recipe.pipeline.precision = state.precision;
          }};
}

/// One switch on all scenes of a kind: times are averaged as ratios, errors as squares.
Result<std::vector<Effect>> effects_of(SurfaceKind kind, std::size_t switch_number, const Effort& effort, const PipelineOptions& pipeline) {
  const std::size_t settings = quality_switches()[switch_number].settings.size();
  std::vector<Setting> turned;
  for (std::size_t setting = 0; setting < settings; ++setting) {
    Quality quality;
    quality.choice[switch_number] = static_cast<int>(setting);
    turned.push_back(setting_of(quality));
  }
  const std::vector<Scene> scenes = scenes_of(kind);
  const auto count = static_cast<double>(scenes.size());
  std::vector<double> logarithms(settings, 0), squares(settings, 0);
  for (const Scene& scene : scenes) {
    const auto measured = measure(scene, turned, effort, pipeline);
    if (!measured) return measured.error();
    for (std::size_t i = 0; i < settings; ++i) {
      logarithms[i] += std::log((*measured)[i].time.ratio) / count;
      squares[i] += std::pow((*measured)[i].to_reference.rmse_codes / 255, 2) / count;
    }
  }
  std::vector<Effect> effects;
  for (std::size_t i = 0; i < settings; ++i) effects.push_back({std::exp(logarithms[i]), std::sqrt(squares[i])});
  return effects;
}

}  // namespace

Result<std::string> measure_adviser_table(const std::string& circumstances, const Effort& effort, const PipelineOptions& pipeline,
                                          const Progress& progress) {
  std::string text = "# " + circumstances + "\n";
  for (const SurfaceKind kind : {SurfaceKind::textured, SurfaceKind::textured_lit, SurfaceKind::lit})
    for (std::size_t i = 0; i < kQualitySwitches; ++i) {
      if (!reason_not_to_turn(i, traits_of(kind)).empty()) continue;
      const QualitySwitch& each = quality_switches()[i];
      progress.tell("adviser: " + std::string(each.name), std::string(name_of(kind)) + " surfaces", each.settings.size());
      const auto effects = effects_of(kind, i, effort, pipeline);
      if (!effects) return effects.error();
      for (std::size_t setting = 0; setting < each.settings.size(); ++setting) {
        char line[200];
        std::snprintf(line, sizeof line, "%s; %s; %s; %.3f; %.4f\n", std::string(name_of(kind)).c_str(), std::string(each.name).c_str(),
                      std::string(each.settings[setting].name).c_str(), (*effects)[setting].time_ratio, (*effects)[setting].rmse * 255);
        text += line;
      }
    }
  return text;
}

}  // namespace tuberia::bench::trade
