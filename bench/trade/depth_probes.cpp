// Probes of the depth buffer.

#include <cmath>
#include <cstdio>

#include "bench/trade/probe_recipe.hpp"
#include "bench/trade/probes.hpp"
#include "pipeline/programs/programs.hpp"

namespace tuberia::bench::trade {
namespace {

constexpr int kPairsSize = 512, kPairCell = 4;
constexpr double kNear = 0.1, kFar = 1e4;

/// One rectangle a cell, all that the eye sees of it; `factor` times as far as the cell's own distance.
std::shared_ptr<const Shape> rectangles_at_distances(double gap, double factor, const glm::vec4& colour) {
  auto shape = std::make_shared<Shape>();
  Random random(4);
  for (int top = 0; top < kPairsSize; top += kPairCell)
    for (int left = 0; left < kPairsSize; left += kPairCell) {
      const double nearest = kNear * std::exp(random.between(0, std::log(kFar / kNear / (1 + gap))));
      const double distance = nearest * factor;
      const auto first = static_cast<std::uint32_t>(shape->positions.size());
      for (const auto& [dx, dy] : {std::pair{0, kPairCell}, {kPairCell, kPairCell}, {kPairCell, 0}, {0, 0}}) {
        const glm::dvec2 window(2.0 * (left + dx) / kPairsSize - 1, 1 - 2.0 * (top + dy) / kPairsSize);
        shape->positions.emplace_back(
            glm::dvec3(window * distance, -distance));  // 90 degrees: the window is as wide as far
        shape->colours.push_back(colour);
      }
      for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) shape->indices.push_back(first + i);
    }
  return shape;
}

double hidden_pairs_percent(const Scene::Picture& picture, const Scene::Picture&) {
  int wrong = 0, pairs = 0;
  for (int y = kPairCell / 2; y < kPairsSize; y += kPairCell)
    for (int x = kPairCell / 2; x < kPairsSize; x += kPairCell, ++pairs) wrong += picture.at(x, y).g > 0.5f ? 0 : 1;
  return 100.0 * wrong / pairs;
}

}  // namespace

Scene depth_pairs(double relative_gap) {
  char name[48];
  std::snprintf(name, sizeof name, "pairs %g apart", relative_gap);
  const auto far_ones = rectangles_at_distances(relative_gap, 1 + relative_gap, {1, 0, 0, 1});
  const auto near_ones = rectangles_at_distances(relative_gap, 1, {0, 1, 0, 1});
  Scene scene{.name = name,
              .what = "16,384 pairs of rectangles at distances of 0.1 to 10,000: the nearer must hide the other",
              .recipe = probe_recipe(kPairsSize, kPairsSize),
              .build = [far_ones, near_ones](const Recipe& recipe) -> Result<Frame> {
                auto frame = Frame::create(recipe, Rgba32F{0, 0, 0, 0});
                if (!frame) return frame.error();
                const PipelineState state = frame->state_for({.at = {0, 0, 0},
                                                              .point_of_interest = {0, 0, -1},
                                                              .fovy_degrees = 90,
                                                              .near_distance = kNear,
                                                              .far_distance = kFar});
                frame->add(far_ones, flat(), state);
                frame->add(near_ones, flat(), state);
                return frame;
              }};
  scene.ideal = [] { return Scene::Picture(kPairsSize, kPairsSize, {0, 1, 0, 1}); };
  scene.error = hidden_pairs_percent;
  return scene;
}

}  // namespace tuberia::bench::trade
