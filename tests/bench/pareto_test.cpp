#include <catch2/catch.hpp>

#include <limits>

#include "bench/figures/label_placement.hpp"
#include "bench/figures/pareto.hpp"
#include "bench/figures/scatter.hpp"

namespace tuberia::bench {
namespace {

/// Numbers that repeat on every machine, few of them, so that many are equal.
std::vector<Choice> many_choices(std::uint32_t seed) {
  std::vector<Choice> choices;
  for (int i = 0; i < 60; ++i) {
    seed = seed * 1664525u + 1013904223u;
    choices.push_back({static_cast<double>(seed >> 28), static_cast<double>(seed >> 24 & 15u)});
  }
  return choices;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("pareto: on the front is exactly what nothing dominates, by growing cost", "[bench][trade]") {
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    const std::vector<Choice> choices = many_choices(seed);
    const std::vector<std::size_t> front = pareto_front(choices);
    std::size_t expected = 0;
    for (const Choice& each : choices) {
      bool is_dominated = false;
      for (const Choice& other : choices) is_dominated = is_dominated || dominates(other, each);
      if (!is_dominated) ++expected;
    }
    REQUIRE(front.size() == expected);
    for (const std::size_t i : front)
      for (const Choice& other : choices) REQUIRE_FALSE(dominates(other, choices[i]));
    for (std::size_t i = 1; i < front.size(); ++i) REQUIRE(choices[front[i - 1]].cost <= choices[front[i]].cost);
  }
}

TEST_CASE("pareto: equal choices are all on the front, those that are no numbers never", "[bench][trade]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(pareto_front(std::vector<Choice>{{1, 1}, {1, 1}, {2, 1}, {1, 2}}) == std::vector<std::size_t>{0, 1});
  CHECK(pareto_front(std::vector<Choice>{{nan, 0}, {3, 4}, {0, nan}}) == std::vector<std::size_t>{1});
  CHECK(pareto_front(std::vector<Choice>{{5, 0}, {1, 9}, {3, 3}}) == std::vector<std::size_t>{1, 2, 0});
  CHECK(pareto_front({}).empty());
}

TEST_CASE("labels: none hides another, a point, or leaves the area; without room there is none", "[bench][trade]") {
  std::vector<Labelled> points;
  for (int i = 0; i < 40; ++i) points.push_back({100.0 + 7 * i, 200.0 + i % 3, "setting " + std::to_string(i)});
  const Box area{60, 10, 500, 400};
  const std::vector<PlacedLabel> placed = place_labels(points, area);
  REQUIRE(placed.size() == points.size());
  CHECK(placed.front().is_shown);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (!placed[i].is_shown) continue;
    CHECK(area.holds(placed[i].box));
    for (std::size_t j = 0; j < placed.size(); ++j) {
      CHECK_FALSE(placed[i].box.overlaps({points[j].x - 3, points[j].y - 3, points[j].x + 3, points[j].y + 3}));
      if (j != i && placed[j].is_shown) CHECK_FALSE(placed[i].box.overlaps(placed[j].box));
    }
  }
  CHECK_FALSE(
      place_labels(std::vector<Labelled>{{5, 5, "far too long a label for this"}}, {0, 0, 20, 20}).front().is_shown);
}

TEST_CASE("scatter: every point is drawn, zeros too, inside the picture", "[bench][trade]") {
  const Scatter scatter{.x = {"time"},
                        .y = {"error"},
                        .groups = {"a", "b"},
                        .points = {{.x = 1, .y = 0, .label = "exact", .is_reference = true},
                                   {.x = 0.5, .y = 2, .label = "<fast>"},
                                   {.x = 0.4, .y = 1e-3, .group = 1, .is_detail = true}}};
  for (const std::string& drawing : {figure_of(scatter), svg_file_of(scatter, "A & B")}) {
    CHECK(occurrences(drawing, "<title>") == 3);
    CHECK(drawing.find("nan") == std::string::npos);
    CHECK(drawing.find("inf") == std::string::npos);
    CHECK(drawing.find("=\"-") == std::string::npos);
    CHECK(drawing.find("<fast>") == std::string::npos);
    CHECK(occurrences(drawing, "class=\"front\"") == 1);
  }
  CHECK(svg_file_of(scatter, "A & B").find("A &amp; B") != std::string::npos);
}

TEST_CASE("scatter: all errors zero, or all times equal, still make a plot", "[bench][trade]") {
  const Scatter scatter{.x = {"time"}, .y = {"error"}, .groups = {"a"}, .points = {{.x = 1, .y = 0}, {.x = 1, .y = 0}}};
  CHECK(figure_of(scatter).find("nan") == std::string::npos);
  CHECK(figure_of(scatter).find("inf") == std::string::npos);
}

}  // namespace tuberia::bench
