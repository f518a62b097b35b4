// The smallest pipeline, and one with everything on, leave every bit as it is.

#include <catch2/catch.hpp>

#include <functional>

#include "scene/neutral_features.hpp"
#include "scene/requirements.hpp"
#include "tests/differential/scene.hpp"
#include "tests/differential/translation.hpp"
#include "tests/support/draws.hpp"

namespace tuberia {
namespace {

using Change = std::function<DrawCall(const DrawCall&, const RenderTargetDescription&)>;

DrawCall as_it_is(const DrawCall& draw, const RenderTargetDescription&) { return draw; }
DrawCall smallest(const DrawCall& draw, const RenderTargetDescription& target) { return requirements_of(draw, target).smallest; }
DrawCall smallest_of_everything(const DrawCall& draw, const RenderTargetDescription& target) {
  return requirements_of(with_everything(draw, target), target).smallest;
}

/// A random scene of the differential tests, all of its draws changed.
class RandomScene {
 public:
  explicit RandomScene(std::uint64_t seed) : scene_(differential::random_scene(seed)), pipeline_({.threads = 1}) {
    const differential::TargetDescription& t = scene_.target;
    target_ = {.width = t.width, .height = t.height, .colour = static_cast<ColourFormat>(t.colour),
               .depth = static_cast<DepthFormat>(t.depth), .stencil = t.has_stencil, .samples = t.samples};
    for (const oracle::Draw& draw : scene_.draws) arrays_.push_back(differential::arrays_of(draw));
    for (std::size_t i = 0; i < arrays_.size(); ++i) draws_.push_back(differential::translated(scene_.draws[i], arrays_[i]));
  }

  const RenderTargetDescription& target() const { return target_; }
  std::span<const DrawCall> draws() const { return draws_; }

  /// A digest of all samples. Draws that need no drawing are left out if `only_needed`.
  std::string drawn(const Change& change, bool only_needed = false) {
    RenderTarget target = *RenderTarget::create(target_);
    const differential::TargetDescription& t = scene_.target;
    ClearCommand clear{.colour = Rgba32F{t.clear_colour.r, t.clear_colour.g, t.clear_colour.b, t.clear_colour.a}, .depth = t.clear_depth};
    if (t.has_stencil) clear.stencil = t.clear_stencil;
    REQUIRE(target.clear(clear, pipeline_.workers()).ok());
    for (std::size_t i = 0; i < draws_.size(); ++i) {
      const bool is_accepted = validate(draws_[i], target, pipeline_.workers()).ok();
      if (is_accepted && !(only_needed && !requirements_of(draws_[i], target_).needs(Feature::drawing)))
        REQUIRE(pipeline_.draw(target, change(draws_[i], target_)).ok());
      if (i == 0 && scene_.clear) REQUIRE(target.clear(differential::translated(*scene_.clear), pipeline_.workers()).ok());
    }
    return test::digest_of_samples(target);
  }

 private:
  differential::Scene scene_;
  RenderTargetDescription target_;
  std::vector<differential::MeshArrays> arrays_;
  std::vector<DrawCall> draws_;
  Pipeline pipeline_;
};

TEST_CASE("requirements: the smallest pipeline and the fullest draw random scenes alike", "[requirements][exact]") {
  constexpr std::uint64_t kScenes = 3000;
  std::array<int, kFeatures> turned_off{};
  int added = 0, left_out = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    INFO("seed " << seed);
    RandomScene scene(seed);
    const std::string plain = scene.drawn(as_it_is);
    REQUIRE(scene.drawn(smallest, true) == plain);
    for (const Feature feature : neutral_features()) {
      INFO(name_of(feature));
      REQUIRE(scene.drawn([&](const DrawCall& draw, const RenderTargetDescription& target) { return with_neutral(draw, feature, target).value_or(draw); }) == plain);
    }
    REQUIRE(scene.drawn(with_everything) == plain);
    REQUIRE(scene.drawn(smallest_of_everything) == plain);
    for (const DrawCall& draw : scene.draws()) {
      const Requirements requirements = requirements_of(draw, scene.target());
      left_out += requirements.needs(Feature::drawing) ? 0 : 1;
      for (const Requirement& r : requirements.features) turned_off[static_cast<std::size_t>(r.feature)] += r.was_on && !r.is_needed ? 1 : 0;
      for (const Feature feature : neutral_features()) added += with_neutral(draw, feature, scene.target()) ? 1 : 0;
    }
  }
  // Otherwise little would have been compared.
  CHECK(left_out > 20);
  CHECK(added > 5000);
  for (const Feature feature : {Feature::vertex_lighting, Feature::two_sided_colours, Feature::user_planes, Feature::polygon_modes,
                                Feature::polygon_offset, Feature::scissor, Feature::interpolation, Feature::blending}) {
    INFO(name_of(feature));
    CHECK(turned_off[static_cast<std::size_t>(feature)] > 0);
  }
}

TEST_CASE("requirements: each feature added alone changes no picture", "[requirements][exact]") {
  for (const bool staged : {false, true})
    for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::srgb8}) {
      const RenderTargetDescription description{.width = 97, .height = 71, .colour = format, .stencil = true};
      const auto drawn = [&](const Change& change) {
        Pipeline pipeline({.threads = 2});
        RenderTarget target = *RenderTarget::create(description);
        pipeline.clear(target, {0.2f, 0.3f, 0.4f, 1});
        for (const test::NamedDraw& draw : staged ? test::staged_draws(false) : test::everyday_draws()) {
          const DrawCall call{.mesh = draw.mesh.view(), .program = draw.program, .state = draw.state};
          INFO(draw.name);
          REQUIRE(pipeline.draw(target, change(call, description)).ok());
        }
        return test::digest_of_samples(target);
      };
      const std::string plain = drawn(as_it_is);
      CHECK(drawn(smallest) == plain);
      CHECK(drawn(with_everything) == plain);
      for (const Feature feature : neutral_features()) {
        INFO(name_of(feature));
        CHECK(drawn([&](const DrawCall& draw, const RenderTargetDescription& target) { return with_neutral(draw, feature, target).value_or(draw); }) == plain);
      }
    }
}

}  // namespace
}  // namespace tuberia
