// The adviser keeps its promise: the error of the whole picture is within the budget, and nothing that also
// keeps it is much faster. Everything is tried, to know.

#include <algorithm>
#include <catch2/catch.hpp>
#include <ctime>
#include <limits>

#include "tests/adviser/scenes.hpp"

namespace tuberia {
namespace {

using test::AdvisedScene;

Image<Rgba8> whole_picture(AdvisedScene& scene, const Quality& quality) {
  RenderTarget target = *RenderTarget::create(scene.target);
  REQUIRE(scene.picture.draw(quality, target, std::nullopt));
  return target.colour_image();
}

double rmse_of(const Image<Rgba8>& image, const Image<Rgba8>& reference) {
  double sum = 0;
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    const Rgba8 a = image.pixels()[i], b = reference.pixels()[i];
    for (const double difference : {a.r - b.r, a.g - b.g, a.b - b.b}) sum += difference * difference;
  }
  return std::sqrt(sum / (3.0 * static_cast<double>(image.pixels().size()))) / 255;
}

/// The shortest of several frames of each quality, in turns, so that a disturbance meets all of them. Of one
/// thread's processor time, which other programs lengthen less than they do the time on the wall.
std::vector<double> shortest_seconds(AdvisedScene& scene, const std::vector<Quality>& qualities, int rounds) {
  RenderTarget target = *RenderTarget::create(scene.target);
  std::vector<double> shortest(qualities.size(), std::numeric_limits<double>::infinity());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < qualities.size(); ++i) {
      const std::clock_t begin = std::clock();
      REQUIRE(scene.picture.draw(qualities[i], target, std::nullopt));
      shortest[i] = std::min(shortest[i], static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
  return shortest;
}

}  // namespace

TEST_CASE("adviser: keeps the error, and takes at most 1.3 times the best admissible time", "[adviser][slow]") {
  for (const test::AdviserScene& description : test::adviser_scenes()) {
    AdvisedScene scene(description);
    const std::vector<Quality> qualities = qualities_for(scene.traits);
    const Image<Rgba8> reference = whole_picture(scene, Quality{});
    std::vector<double> errors;
    for (const Quality& quality : qualities) errors.push_back(rmse_of(whole_picture(scene, quality), reference));
    const std::vector<double> seconds = shortest_seconds(scene, qualities, 9);

    for (const double codes : {0.5, 3.0}) {
      const double budget = codes / 255;
      Adviser adviser(scene.picture, scene.target, scene.traits);
      const auto advice = adviser.advise({.rmse = budget, .seconds = {}});
      REQUIRE(advice);
      const auto chosen = static_cast<std::size_t>(std::find(qualities.begin(), qualities.end(), advice->chosen.quality) - qualities.begin());
      double best = std::numeric_limits<double>::infinity();
      std::size_t best_number = 0;
      for (std::size_t i = 0; i < qualities.size(); ++i)
        if (errors[i] <= budget && seconds[i] < best) best = seconds[i], best_number = i;

      INFO(description.name << ", budget " << codes << "/255: " << words_of(advice->chosen.quality) << " with " << errors[chosen] * 255 << " in "
                            << seconds[chosen] * 1e3 << " ms; best is " << words_of(qualities[best_number]) << " in " << best * 1e3 << " ms");
      CHECK(advice->keeps_budget);
      CHECK(errors[chosen] <= budget);
      // A machine that does other things as well may have disturbed one of them: then both are timed again, for longer.
      std::vector<double> both{seconds[chosen], best};
      if (both[0] > 1.3 * both[1]) both = shortest_seconds(scene, {advice->chosen.quality, qualities[best_number]}, 60);
      CHECK(both[0] <= 1.3 * both[1]);
    }
  }
}

}  // namespace tuberia
