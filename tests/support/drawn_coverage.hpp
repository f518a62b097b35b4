#pragma once
// Which pixels triangles cover when the whole pipeline draws them: every fragment adds its triangle's
// number and 1 to two channels of floats, so that sums tell what [rules] publishes.

#include <span>

#include "tests/support/coverage.hpp"
#include "tests/support/render.hpp"

namespace tuberia::test {

/// The published figures of a set of triangles; see Coverage for the hash.
struct PublishedCoverage {
  std::uint64_t count = 0, hash = 0;
  bool operator==(const PublishedCoverage&) const = default;
};

/// State that adds colours, whatever the depth.
inline PipelineState adding() {
  PipelineState state;
  state.depth = kDepthOff;
  state.blend.mode = BlendMode::additive;
  return state;
}

/// What is in a target of floats to which `adding` has drawn (number, 1, 0, 0) everywhere.
inline PublishedCoverage published(const Image<Rgba32F>& sums) {
  PublishedCoverage coverage;
  std::uint64_t pixel = 1;
  for (const Rgba32F& sum : sums.pixels()) {
    // Whole numbers are exact in a float up to 2^24.
    if (sum.r >= 0x1p24f) FAIL("too many triangles for exact sums");
    coverage.count += static_cast<std::uint64_t>(sum.g);
    coverage.hash += pixel++ * static_cast<std::uint64_t>(sum.r);
  }
  return coverage;
}

/// Colours for `published`: those of triangle i are (i + 1, 1, 0, 0), from the first one's number on.
inline std::vector<glm::vec4> numbers_as_colours(std::size_t triangles, std::size_t first = 0) {
  std::vector<glm::vec4> colours;
  for (std::size_t i = 0; i < 3 * triangles; ++i) colours.push_back({static_cast<float>(first + i / 3 + 1), 1, 0, 0});
  return colours;
}

/// Snapped triangles as the pipeline takes them, w = 1 and depth 0.
inline std::vector<ScreenVertex> screen_vertices(std::span<const Triangle> triangles) {
  std::vector<ScreenVertex> vertices;
  for (const Triangle& triangle : triangles)
    for (const SnappedPoint& p : triangle) vertices.push_back({.x = p.x, .y = p.y});
  return vertices;
}

/// How often each pixel is covered (green), and by whom (red, a sum), through the whole pipeline.
inline Image<Rgba32F> drawn_sums(std::span<const Triangle> triangles, int width, int height, const PipelineOptions& options,
                                 const PipelineState& state = adding()) {
  Studio studio({.width = width, .height = height, .colour = ColourFormat::rgba32f, .options = options});
  const auto vertices = screen_vertices(triangles);
  const auto colours = numbers_as_colours(triangles.size());
  studio.draw({.screen_positions = vertices, .colours = colours}, flat(), state);
  return studio.target().linear_image();
}

}  // namespace tuberia::test
