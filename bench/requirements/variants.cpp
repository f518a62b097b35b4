#include "bench/requirements/variants.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "bench/figures/statistics.hpp"
#include "pipeline/programs/programs.hpp"
#include "scene/neutral_features.hpp"

namespace tuberia::bench {
namespace {

using Clock = std::chrono::steady_clock;
double milliseconds_since(Clock::time_point begin) { return std::chrono::duration<double, std::milli>(Clock::now() - begin).count(); }

/// Nothing but the triangles in one colour each: no depth, no blending, no light, no texture.
DrawCall bare(const DrawCall& smallest) {
  DrawCall draw{.mesh = {.positions = smallest.mesh.positions, .indices = smallest.mesh.indices}, .program = flat(), .state = {}};
  draw.state.transform.world_from_object = smallest.state.transform.world_from_object;
  draw.state.transform.clip_from_world = smallest.state.transform.clip_from_world;
  draw.state.depth = kDepthOff;
  draw.state.blend.write = smallest.state.blend.write;
  return draw;
}

/// The bare draw with what a scene needs of one thing.
std::optional<DrawCall> with_needed(const DrawCall& base, const Requirements& requirements, Feature feature) {
  if (!requirements.needs(feature)) return std::nullopt;
  const DrawCall& full = requirements.smallest;
  DrawCall draw = base;
  switch (feature) {
    case Feature::shading:
      draw.mesh = full.mesh;
      draw.program = full.program;
      draw.state.transform = full.state.transform;
      break;
    case Feature::culling: draw.state.culling = full.state.culling; break;
    case Feature::depth_test: draw.state.depth = full.state.depth; break;
    case Feature::blending:
      draw.state.blend = full.state.blend;
      draw.mesh.colours = full.mesh.colours;
      break;
    case Feature::user_planes: draw.state.clipping = full.state.clipping; break;
    default: return std::nullopt;
  }
  return draw;
}

std::string name_of_needed(Feature feature, const DrawCall& smallest) {
  if (feature == Feature::shading) return "program " + std::string(smallest.program.interface().name);
  if (feature == Feature::depth_test) return smallest.state.depth.write ? "depth test and write" : "depth test";
  return std::string(name_of(feature));
}

class Frames {
 public:
  Frames(const RequirementScene& scene, const MeasureOptions& options)
      : pipeline_({.threads = options.threads, .instruction_set = options.instruction_set}), target_(*RenderTarget::create(scene.target)) {}

  double milliseconds(std::span<const DrawCall> draws) {
    const auto begin = Clock::now();
    pipeline_.clear(target_, {0.03f, 0.04f, 0.05f, 1});
    for (const DrawCall& draw : draws)
      if (!pipeline_.draw(target_, draw)) std::abort();
    return milliseconds_since(begin);
  }

  struct Picture {
    Image<Rgba8> colours;
    Image<std::int32_t> depths;
    bool operator==(const Picture&) const = default;
  };
  Picture picture(std::span<const DrawCall> draws) {
    milliseconds(draws);
    return {target_.colour_image(), target_.depth_codes()};
  }

 private:
  Pipeline pipeline_;
  RenderTarget target_;
};

std::vector<Requirements> examine(const RequirementScene& scene, MeasuredScene& measured) {
  const auto begin = Clock::now();
  std::vector<Requirements> all;
  for (const DrawCall& draw : scene.draws) all.push_back(requirements_of(draw, scene.target));
  measured.examining_milliseconds = milliseconds_since(begin);
  const auto is_needed = [](const Requirements& r) { return r.needs(Feature::drawing); };
  measured.draws = static_cast<int>(all.size());
  measured.needed_draws = static_cast<int>(std::count_if(all.begin(), all.end(), is_needed));
  all.erase(std::remove_if(all.begin(), all.end(), [&](const Requirements& r) { return !is_needed(r); }), all.end());
  return all;
}

void add_bare_variants(const std::vector<Requirements>& needed, std::vector<Variant>& variants) {
  std::vector<DrawCall> base;
  for (const Requirements& r : needed) base.push_back(bare(r.smallest));
  variants.push_back({Variant::Kind::bare, "bare: one colour a triangle, no depth", base});
  for (const Feature feature : {Feature::user_planes, Feature::culling, Feature::depth_test, Feature::shading, Feature::blending}) {
    std::vector<DrawCall> draws;
    for (std::size_t i = 0; i < base.size(); ++i)
      if (auto draw = with_needed(base[i], needed[i], feature)) draws.push_back(*std::move(draw));
    if (draws.size() == base.size()) variants.push_back({Variant::Kind::needed_alone, "bare + " + name_of_needed(feature, needed[0].smallest), std::move(draws)});
  }
}

void add_neutral_variants(const RequirementScene& scene, const std::vector<Requirements>& needed, std::vector<Variant>& variants) {
  for (const Feature feature : neutral_features()) {
    std::vector<DrawCall> draws;
    for (const Requirements& r : needed)
      if (auto draw = with_neutral(r.smallest, feature, scene.target)) draws.push_back(*std::move(draw));
    if (draws.size() == needed.size()) variants.push_back({Variant::Kind::neutral_alone, std::string(name_of(feature)), std::move(draws)});
  }
  std::vector<DrawCall> everything;
  for (const DrawCall& draw : scene.draws) everything.push_back(with_everything(draw, scene.target));
  variants.push_back({Variant::Kind::everything, "everything enabled", std::move(everything)});
}

void compare_pictures(Frames& frames, MeasuredScene& measured) {
  const Frames::Picture picture = frames.picture(measured.of(Variant::Kind::as_asked).draws);
  for (Variant& variant : measured.variants) {
    if (variant.kind == Variant::Kind::bare || variant.kind == Variant::Kind::needed_alone) continue;
    variant.has_same_picture = frames.picture(variant.draws) == picture;
    measured.pictures_are_equal &= variant.has_same_picture;
  }
}

}  // namespace

const Variant& MeasuredScene::of(Variant::Kind kind) const {
  return *std::find_if(variants.begin(), variants.end(), [kind](const Variant& v) { return v.kind == kind; });
}

MeasuredScene measure(const RequirementScene& scene, const MeasureOptions& options) {
  MeasuredScene measured;
  measured.name = scene.name;
  measured.caption = scene.caption;
  const std::vector<Requirements> needed = examine(scene, measured);
  measured.requirements = needed.front();
  add_bare_variants(needed, measured.variants);
  std::vector<DrawCall> smallest;
  for (const Requirements& r : needed) smallest.push_back(r.smallest);
  measured.variants.push_back({Variant::Kind::smallest, "smallest pipeline", std::move(smallest)});
  measured.variants.push_back({Variant::Kind::as_asked, "as the scene asks", scene.draws});
  add_neutral_variants(scene, needed, measured.variants);

  Frames frames(scene, options);
  compare_pictures(frames, measured);  // which warms up, too
  std::vector<std::vector<double>> times(measured.variants.size());
  for (int round = 0; round < options.rounds; ++round)
    for (std::size_t i = 0; i < times.size(); ++i) times[i].push_back(frames.milliseconds(measured.variants[i].draws));
  for (std::size_t i = 0; i < times.size(); ++i) {
    measured.variants[i].milliseconds = median(times[i]);
    measured.variants[i].first_quarter = quantile(times[i], 0.25);
    measured.variants[i].third_quarter = quantile(times[i], 0.75);
  }
  return measured;
}

}  // namespace tuberia::bench
