// Clip positions with extreme w, cut by every plane; points and lines of every kind.

#include <cmath>

#include "pipeline/programs/programs.hpp"
#include "tests/extremes/determinism/scene.hpp"
#include "tests/support/random.hpp"
#include "tests/support/shapes.hpp"

namespace tuberia::determinism {

namespace {

glm::vec4 random_colour(test::Random& random) {
  return {random.between(0, 1), random.between(0, 1), random.between(0, 1), random.between(0, 1)};
}

/// w from behind the eye to 2^30, in steps of a factor of 2; now and then a direction, or nothing at all.
/// (One random number a statement: compilers differ in which argument of a call they evaluate first.)
glm::vec4 extreme_position(test::Random& random) {
  const std::int64_t kind = random.below(24);
  if (kind == 0) return glm::vec4(0);
  const int exponent = static_cast<int>(random.below(44)) - 14;
  const float size = random.between(1, 2);
  const float w = kind == 1 ? 0.0f : kind < 6 ? -size : std::ldexp(size, exponent);
  const float reach = kind == 2 ? 1e30f : w == 0 ? 1.0f : 2 * std::abs(w);
  return {random.between(-1, 1) * reach, random.between(-1, 1) * reach, random.between(-1, 1) * reach, w};
}

Scene clipped_and_w_extremes() {
  test::Random random(61);
  Layer layer{.program = gouraud()};
  for (int i = 0; i < 1500; ++i) {
    // All of a triangle scaled by a power of two: denormal ones, too.
    const int scale = i % 5 == 0 ? static_cast<int>(random.below(120)) - 110 : 0;
    for (int k = 0; k < 3; ++k) {
      const glm::vec4 p = extreme_position(random);
      layer.clip_positions.push_back({std::ldexp(p.x, scale), std::ldexp(p.y, scale), std::ldexp(p.z, scale), std::ldexp(p.w, scale)});
      layer.mesh.colours.push_back(random_colour(random));
    }
  }
  layer.state.clipping.user_plane_count = 1;
  layer.state.clipping.user_planes[0] = {0.5, -0.25, 0.125, 0.75};
  return {.name = "clipped-w-extremes", .target = {.width = 200, .height = 150, .colour = ColourFormat::rgba32f, .depth = DepthFormat::d32f},
          .layers = seen_and_summed(layer)};
}

Layer shape_layer(Topology topology, int count, std::uint64_t seed) {
  test::Random random(seed);
  Layer layer{.program = gouraud()};
  layer.state.assembly.topology = topology;
  for (int i = 0; i < count; ++i) {
    layer.clip_positions.push_back({random.between(-1.5f, 1.5f), random.between(-1.5f, 1.5f), random.between(-1, 1), random.between(0.25f, 1.5f)});
    layer.mesh.colours.push_back(random_colour(random));
  }
  return layer;
}

Scene lines_and_points(int samples) {
  Layer thin = shape_layer(Topology::line_strip, 120, 62), wide = shape_layer(Topology::lines, 60, 63), loop = shape_layer(Topology::line_loop, 30, 64);
  wide.state.rasterization.line.width_pixels = 5.25f;
  loop.state.rasterization.line = {.width_pixels = 2, .stipple = StipplePattern{0x1f0d, 3}};
  Layer squares = shape_layer(Topology::points, 80, 65), discs = shape_layer(Topology::points, 80, 66);
  squares.state.rasterization.point.size_pixels = 7.5f;
  discs.state.rasterization.point = {.size_pixels = 11.25f, .round = true};
  Layer outlines = shape_layer(Topology::triangles, 60, 67);
  outlines.state.rasterization.front_mode = PolygonMode::line;
  outlines.state.rasterization.back_mode = PolygonMode::point;
  outlines.state.rasterization.point.size_pixels = 3;
  outlines.state.rasterization.polygon_offset = {.factor = 1, .units = 2};
  return {.name = samples == 1 ? "lines-points" : "lines-points-multisampled", .target = {.width = 150, .height = 130, .samples = samples},
          .layers = {thin, wide, loop, squares, discs, outlines}};
}

}  // namespace

std::vector<Scene> clipping_scenes() { return {clipped_and_w_extremes(), lines_and_points(1), lines_and_points(4)}; }

}  // namespace tuberia::determinism
