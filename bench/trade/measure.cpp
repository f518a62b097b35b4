#include "bench/trade/measure.hpp"

#include <list>

namespace tuberia::bench::trade {
namespace {

Result<Frame> ready_frame(const Scene& scene, const Setting& setting, const PipelineOptions& pipeline,
                          int supersampling = 1) {
  Recipe recipe = scene.recipe;
  recipe.pipeline = pipeline;
  setting.apply(recipe);
  recipe.supersampling *= supersampling;
  auto frame = scene.build(recipe);
  if (!frame) return frame.error();
  if (const auto drawn = frame->draw(); !drawn) return drawn.error();
  return frame;
}

Result<Scene::Picture> ideal_picture(const Scene& scene, const Setting& reference, const PipelineOptions& pipeline) {
  if (scene.ideal) return scene.ideal();
  const auto frame = ready_frame(scene, reference, pipeline, scene.ideal_supersampling);
  if (!frame) return frame.error();
  return frame->picture();
}

Result<Nothing> judge(const Scene& scene, const Scene::Picture& picture, const Scene::Picture& ideal,
                      const Scene::Picture& reference, Measurement& measurement) {
  if (scene.is_picture) {
    const auto to_ideal = picture_error(picture, ideal, scene.signal);
    if (!to_ideal) return to_ideal.error();
    const auto to_reference = code_error(picture, reference, scene.signal);
    if (!to_reference) return to_reference.error();
    measurement.to_ideal = *to_ideal;
    measurement.to_reference = *to_reference;
  }
  measurement.error = scene.error ? scene.error(picture, ideal) : measurement.to_ideal.rmse_codes;
  return Nothing{};
}

}  // namespace

Result<Image<Rgba8>> screen_picture(const Scene& scene, const Setting& setting, const PipelineOptions& pipeline) {
  const auto frame = ready_frame(scene, setting, pipeline);
  if (!frame) return frame.error();
  return screen_codes(frame->picture(), scene.signal);
}

Result<std::vector<Measurement>> measure(const Scene& scene, const std::vector<Setting>& settings, const Effort& effort,
                                         const PipelineOptions& pipeline) {
  const auto ideal = ideal_picture(scene, settings.front(), pipeline);
  if (!ideal) return ideal.error();

  // Every setting's picture, and its frame to be timed.
  std::list<Frame> frames;  // in a list they stay where they are
  std::vector<std::function<void()>> ways;
  std::vector<Measurement> measurements;
  Scene::Picture reference;
  for (const Setting& setting : settings) {
    auto frame = ready_frame(scene, setting, pipeline);
    if (!frame) return Error{scene.name + ", " + setting.name + ": " + frame.error().message};
    frames.push_back(*std::move(frame));
    ways.emplace_back([&frame = frames.back()] { frame.draw().value(); });
    const Scene::Picture picture = frames.back().picture();
    if (measurements.empty()) reference = picture;
    measurements.push_back({.setting = setting.name, .time = {}, .error = 0, .to_ideal = {}, .to_reference = {}});
    measurements.back().middle = picture.at(picture.width() / 2, picture.height() / 2).r;
    if (const auto judged = judge(scene, picture, *ideal, reference, measurements.back()); !judged)
      return judged.error();
  }

  const std::vector<RelativeTime> times = time_in_turns(ways, effort);
  for (std::size_t i = 0; i < times.size(); ++i) measurements[i].time = times[i];
  return measurements;
}

}  // namespace tuberia::bench::trade
