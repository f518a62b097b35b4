// Snapped triangles that go straight to the rasterizer: the random sets of [rules, cases 08 to 12].

#include "pipeline/programs/programs.hpp"
#include "tests/extremes/determinism/scene.hpp"
#include "tests/support/triangles.hpp"

namespace tuberia::determinism {

namespace {

/// Every corner with a colour, a depth and a w of its own, so that all of interpolation shows.
Layer layer_of(const std::vector<test::Triangle>& triangles, std::uint64_t seed) {
  test::Random random(seed);
  Layer layer{.program = gouraud()};
  for (const test::Triangle& triangle : triangles)
    for (const SnappedPoint& p : triangle) {
      layer.screen_positions.push_back({.x = p.x, .y = p.y, .depth = random.between(0, 1), .w = random.between(0.5f, 8)});
      layer.mesh.colours.push_back({random.between(0, 1), random.between(0, 1), random.between(0, 1), random.between(0, 1)});
    }
  return layer;
}

/// Near ones win, whether small or large depths are near; targets of floats get the sum of all, too.
Scene opaque(std::string name, const std::vector<test::Triangle>& triangles, const RenderTargetDescription& target, Compare test) {
  Layer layer = layer_of(triangles, 1000);
  layer.state.depth.test = test;
  const bool stores_floats = target.colour == ColourFormat::rgba16f || target.colour == ColourFormat::rgba32f;
  Scene scene{.name = std::move(name), .target = target, .layers = stores_floats ? seen_and_summed(layer) : std::vector{layer}};
  scene.far_depth = test == Compare::greater || test == Compare::greater_equal ? 0.0f : 1.0f;
  return scene;
}

}  // namespace

std::vector<Scene> coverage_scenes() {
  return {
      opaque("random-08", test::random_triangles(1, 2000, 0, 65536), {.width = 256, .height = 256, .colour = ColourFormat::rgba32f}, Compare::less),
      opaque("random-08-beyond", test::random_triangles(7, 2000, -65536, 131072),
             {.width = 256, .height = 256, .colour = ColourFormat::srgb8, .depth = DepthFormat::d32f}, Compare::greater_equal),
      opaque("guard-band-09", test::random_triangles(5, 500, -8388608, 8388607),
             {.width = 128, .height = 96, .colour = ColourFormat::rgba32f, .depth = DepthFormat::d16}, Compare::less_equal),
      opaque("small-10", test::small_triangles(3, 20000, 128, 128),
             {.width = 128, .height = 128, .colour = ColourFormat::rgba16f}, Compare::greater),
      opaque("slivers", test::slivers(23, 2000, 70000), {.width = 256, .height = 256, .colour = ColourFormat::rgba32f}, Compare::less),
      opaque("jittered-mesh-12", test::jittered_mesh(), {.width = 128, .height = 96, .colour = ColourFormat::rgba32f}, Compare::always),
  };
}

}  // namespace tuberia::determinism
