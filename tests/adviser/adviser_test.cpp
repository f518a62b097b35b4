#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/adviser/scenes.hpp"

namespace tuberia {
namespace {

/// Qualities of one switch only, so that each is worse than the one before.
std::vector<Prospect> ladder(const std::vector<double>& costs, const std::vector<double>& burdens) {
  std::vector<Prospect> prospects;
  for (std::size_t i = 0; i < costs.size(); ++i) prospects.push_back({{{static_cast<int>(i)}}, costs[i], burdens[i]});
  return prospects;
}

bool is_worse_on_ladder(const Quality& failed, const Quality& other) { return failed.is_at_least(other); }

}  // namespace

TEST_CASE("adviser: the search takes the cheapest prospect when predictions hold", "[adviser]") {
  const std::vector<Prospect> prospects = ladder({1, 0.8, 0.6, 0.4}, {0, 0.3, 0.9, 2});
  const auto found = search(prospects, is_worse_on_ladder, [&](const Quality& quality) -> Result<Outcome> {
    const Prospect& prospect = prospects[static_cast<std::size_t>(quality.choice[0])];
    return Outcome{prospect.cost, prospect.burden};
  });
  REQUIRE(found);
  CHECK(found->chosen == 2);
  CHECK(found->keeps_budget);
  CHECK(found->broken_predictions == 0);
}

TEST_CASE("adviser: the search steps up where predictions were too good, and down where too bad", "[adviser]") {
  const std::vector<Prospect> prospects = ladder({1, 0.8, 0.6, 0.4}, {0, 0.3, 0.9, 2});
  const auto with_burdens = [&](const std::vector<double>& burdens) {
    const auto found = search(prospects, is_worse_on_ladder, [&](const Quality& quality) -> Result<Outcome> {
      const auto i = static_cast<std::size_t>(quality.choice[0]);
      return Outcome{prospects[i].cost, burdens[i]};
    });
    REQUIRE(found);
    return *found;
  };
  const SearchResult up = with_burdens({0, 0.8, 1.5, 4});
  CHECK(up.chosen == 1);
  CHECK(up.broken_predictions == 1);
  CHECK(with_burdens({0, 1.2, 1.5, 4}).chosen == 0);
  CHECK(with_burdens({0, 0.1, 0.3, 0.9}).chosen == 3);
  const SearchResult hopeless = with_burdens({1.1, 1.2, 1.5, 4});
  CHECK_FALSE(hopeless.keeps_budget);
  CHECK(hopeless.chosen == 0);
}

TEST_CASE("adviser: an error while trying ends the search", "[adviser]") {
  const auto found = search(ladder({1}, {0}), is_worse_on_ladder, [](const Quality&) -> Result<Outcome> { return Error{"no target"}; });
  REQUIRE_FALSE(found);
  CHECK(found.error().message == "no target");
}

TEST_CASE("adviser: the sampled tiles are different ones, and spread evenly", "[adviser]") {
  for (const int tiles : {1, 15, 240, 1000})
    for (const int count : {1, 16, 40}) {
      const std::vector<int> numbers = spread_tiles(tiles, count);
      CHECK(static_cast<int>(numbers.size()) == std::min(tiles, count));
      CHECK(std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end());
      CHECK(numbers.front() >= 0);
      CHECK(numbers.back() < tiles);
    }
  // No gap is more than three times the mean.
  const std::vector<int> numbers = spread_tiles(240, 40);
  for (std::size_t i = 1; i < numbers.size(); ++i) CHECK(numbers[i] - numbers[i - 1] <= 18);
}

TEST_CASE("adviser: a table is refused with the number of its line", "[adviser]") {
  const auto message_of = [](std::string_view text) { return MeasuredTrade::parse(text).error().message; };
  CHECK(message_of("lit; precision; fast; 0.9") == "line 1: five fields are expected, but there are 4");
  CHECK(message_of("# of today\n\nglass; precision; fast; 0.9; 0.1") == "line 3: no kind of surface is called 'glass'");
  CHECK(message_of("lit; colour; fast; 0.9; 0.1") == "line 1: no switch is called 'colour'");
  CHECK(message_of("lit; precision; slow; 0.9; 0.1") == "line 1: the switch 'precision' has no setting 'slow'");
  CHECK(message_of("lit; precision; fast; 0.9; much") == "line 1: 'lit; precision; fast; 0.9; much' does not end in two numbers");
  CHECK(message_of("lit; precision; fast; 0.9; 0.1") == "textured: the setting 'anisotropic 16' of the switch 'filter' is missing");
}

TEST_CASE("adviser: the built-in table is whole, its references cost nothing, and predictions multiply", "[adviser]") {
  const MeasuredTrade& trade = MeasuredTrade::built_in();
  CHECK_FALSE(trade.circumstances().empty());
  for (const SurfaceKind kind : {SurfaceKind::textured, SurfaceKind::textured_lit, SurfaceKind::lit}) {
    const SurfaceTraits traits = traits_of(kind);
    CHECK(kind_of(traits) == kind);
    const Effect reference = trade.predict(kind, Quality{});
    CHECK(reference.time_ratio == 1);
    CHECK(reference.rmse == 0);
    for (const Quality& quality : qualities_for(traits)) {
      double ratio = 1, squares = 0;
      for (std::size_t i = 0; i < kQualitySwitches; ++i) {
        if (quality.choice[i] == 0) continue;
        ratio *= trade.effect(kind, i, quality.choice[i]).time_ratio;
        squares += std::pow(trade.effect(kind, i, quality.choice[i]).rmse, 2);
      }
      CHECK(trade.predict(kind, quality).time_ratio == Approx(ratio));
      CHECK(trade.predict(kind, quality).rmse == Approx(std::sqrt(squares)));
    }
  }
}

TEST_CASE("adviser: only switches that matter are turned", "[adviser]") {
  CHECK(qualities_for({.textured = true, .lit = true}).size() == 7 * 2 * 2 * 2);
  CHECK(qualities_for({.textured = true, .lit = false}).size() == 7 * 2 * 2);
  CHECK(qualities_for({.textured = false, .lit = true}).size() == 2 * 2 * 2);
  CHECK(qualities_for({.textured = true, .lit = true}).front().is_reference());
  CHECK(words_of(Quality{}) == "reference");
  CHECK(words_of(Quality{{3, 1, 0, 1}}) == "filter trilinear; lighting at vertices; precision fast");
}

TEST_CASE("adviser: with no error allowed it draws the reference, with all the time it draws the reference", "[adviser]") {
  test::AdvisedScene scene(test::adviser_scenes().front());
  Adviser adviser(scene.picture, scene.target, scene.traits);
  const auto exact = adviser.advise({.rmse = 0.0, .seconds = {}});
  INFO((exact ? "" : exact.error().message));
  REQUIRE(exact.ok());
  CHECK(exact->keeps_budget);
  CHECK(exact->chosen.rmse == 0);
  const auto slow = adviser.advise({.rmse = {}, .seconds = 100.0});
  REQUIRE(slow);
  CHECK(slow->chosen.rmse == 0);
  const auto never = adviser.advise({.rmse = {}, .seconds = 1e-9});
  REQUIRE(never);
  CHECK_FALSE(never->keeps_budget);
}

TEST_CASE("adviser: the sample's upper estimate holds for the whole picture", "[adviser]") {
  test::AdviserScene large = test::adviser_scenes()[7];
  large.width = 960;
  large.height = 576;
  test::AdvisedScene scene(large);
  Adviser adviser(scene.picture, scene.target, scene.traits);
  RenderTarget target = *RenderTarget::create(scene.target);
  REQUIRE(scene.picture.draw(Quality{}, target, std::nullopt));
  const Image<Rgba8> reference = target.colour_image();
  for (const Quality& quality : {Quality{{3, 0, 0, 0}}, Quality{{6, 0, 0, 0}}, Quality{{0, 1, 0, 0}}, Quality{{0, 0, 1, 0}}}) {
    const auto trial = adviser.attempt(quality);
    REQUIRE(trial);
    REQUIRE(scene.picture.draw(quality, target, std::nullopt));
    const Image<Rgba8> image = target.colour_image();
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
      const Rgba8 a = image.pixels()[i], b = reference.pixels()[i];
      for (const double difference : {a.r - b.r, a.g - b.g, a.b - b.b}) sum += difference * difference;
    }
    const double rmse = std::sqrt(sum / (3.0 * static_cast<double>(image.pixels().size()))) / 255;
    INFO(words_of(quality));
    CHECK(rmse <= trial->rmse_at_most);
    CHECK(trial->rmse_at_most <= 2 * rmse);
  }
}

}  // namespace tuberia
