// Pictures of points, lines, polygon modes and all that moves or cuts polygons.

#include <catch2/catch.hpp>

#include "tests/golden/golden_scene.hpp"

namespace tuberia {

namespace {

using test::Mesh;
using test::Studio;

glm::vec4 rainbow(int i) {
  return glm::vec4(static_cast<float>(i * 3 % 7) / 6.0f, static_cast<float>(i * 5 % 7 + 1) / 7.0f, static_cast<float>(i * 2 % 7) / 6.0f, 1.0f);
}

/// Squares above, discs below, each row of growing size.
void points_of_all_sizes(Studio& studio) {
  PipelineState state;
  state.assembly.topology = Topology::points;
  const float sizes[7] = {1, 2, 3.5f, 6, 11, 17, 24};
  for (int row = 0; row < 2; ++row)
    for (int i = 0; i < 7; ++i) {
      Mesh mesh;
      const float across = -0.9f + 0.28f * static_cast<float>(i) + 0.003f * static_cast<float>(i * i);
      mesh.positions = {{across, row == 0 ? 0.75f : -0.25f, 0}, {across + 0.013f, row == 0 ? 0.25f : -0.75f, 0}};
      mesh.colours = {rainbow(i), rainbow(i + 3)};
      state.rasterization.point = {.size_pixels = sizes[i], .round = row == 1};
      studio.draw(mesh.view(), gouraud(), state);
    }
}

/// Stars of lines: one pixel wide, wide, stippled, and a stippled strip and loop.
void lines_of_all_kinds(Studio& studio) {
  PipelineState state;
  state.assembly.topology = Topology::lines;
  const LineState kinds[4] = {{}, {.width_pixels = 3}, {.stipple = StipplePattern{.bits = 0x00ff, .factor = 1}},
                              {.width_pixels = 2, .stipple = StipplePattern{.bits = 0x5555, .factor = 2}}};
  const float ring[16][2] = {{1, 0}, {0.92f, 0.38f}, {0.71f, 0.71f}, {0.38f, 0.92f}, {0, 1}, {-0.38f, 0.92f}, {-0.71f, 0.71f}, {-0.92f, 0.38f},
                             {-1, 0}, {-0.92f, -0.38f}, {-0.71f, -0.71f}, {-0.38f, -0.92f}, {0, -1}, {0.38f, -0.92f}, {0.71f, -0.71f}, {0.92f, -0.38f}};
  for (int kind = 0; kind < 4; ++kind) {
    state.viewport.viewport = test::grid_cell(kind % 2, kind / 2, 3, 2);
    state.rasterization.line = kinds[kind];
    Mesh star;
    for (const auto& tip : ring) {
      star.positions.push_back({0.15f * tip[0], 0.15f * tip[1], 0});
      star.positions.push_back({0.95f * tip[0], 0.95f * tip[1], 0});
      star.colours.push_back({1, 1, 1, 1});
      star.colours.push_back(rainbow(static_cast<int>(star.colours.size())));
    }
    studio.draw(star.view(), gouraud(), state);
  }
  // The pattern runs on along a strip and round a loop.
  state.rasterization.line = {.stipple = StipplePattern{.bits = 0x0fff, .factor = 1}};
  for (int i = 0; i < 2; ++i) {
    state.viewport.viewport = test::grid_cell(2, i, 3, 2);
    state.assembly.topology = i == 0 ? Topology::line_strip : Topology::line_loop;
    Mesh chain;
    for (int k = 0; k < 16; ++k) {
      const float reach = i == 0 ? 0.95f - 0.05f * static_cast<float>(k) : 0.9f;
      chain.positions.push_back({reach * ring[k][0], reach * ring[k][1], 0});
      chain.colours.push_back(rainbow(k));
    }
    studio.draw(chain.view(), gouraud(), state);
  }
}

PipelineState seen_from(glm::dvec3 eye) {
  PipelineState state;
  state.transform.clip_from_world = test::clip_from_world(eye, 160.0 / 120.0);
  return state;
}

/// Spheres: edges in front, corners in front, edges behind through a front that is cut away.
void polygon_modes(Studio& studio) {
  PipelineState state = seen_from({0, 0.6, 4});
  const Mesh ball = test::sphere(8);
  const PolygonMode modes[3][2] = {{PolygonMode::line, PolygonMode::line}, {PolygonMode::point, PolygonMode::line}, {PolygonMode::fill, PolygonMode::line}};
  for (int i = 0; i < 3; ++i) {
    state.transform.world_from_object = translation({-1.9 + 1.9 * i, 0, 0});
    state.rasterization.front_mode = modes[i][0];
    state.rasterization.back_mode = modes[i][1];
    state.rasterization.point = {.size_pixels = 3, .round = true};
    state.culling.cull = i == 0 ? CullFace::back : CullFace::none;
    state.clipping.user_plane_count = i == 2 ? 1 : 0;
    state.clipping.user_planes[0] = clip_plane_from_world({-0.6, 0.5, -0.6, 1.15}, state.transform.clip_from_world);
    studio.draw(ball.view(), gouraud(), state);
  }
}

/// Squares as edges without their diagonals, and with every edge but one.
void edge_flags(Studio& studio) {
  PipelineState state;
  state.rasterization.front_mode = state.rasterization.back_mode = PolygonMode::line;
  for (int i = 0; i < 3; ++i) {
    Mesh square;
    const float x = -0.9f + 0.65f * static_cast<float>(i);
    const glm::vec3 a{x, -0.6f, 0}, b{x + 0.5f, -0.6f, 0}, c{x + 0.5f, 0.6f, 0}, d{x, 0.6f, 0};
    square.positions = {a, b, c, a, c, d};
    square.colours.assign(6, rainbow(i + 1));
    MeshView view = square.view();
    const std::uint8_t all[6] = {1, 1, 1, 1, 1, 1}, no_diagonal[6] = {1, 1, 0, 0, 1, 1}, open[6] = {0, 1, 0, 0, 1, 1};
    view.edge_flags = i == 0 ? all : i == 1 ? no_diagonal : open;
    studio.draw(view, gouraud(), state);
  }
}

/// A grid drawn on the very surface that it covers: it fights on the left, and lies on top on the right.
void polygon_offset(Studio& studio) {
  const Mesh ball = test::sphere(12);
  for (int i = 0; i < 2; ++i) {
    PipelineState state = seen_from({0, 1.2, 2.6});
    state.transform.world_from_object = translation({i == 0 ? -1.1 : 1.1, 0, 0});
    Mesh blue = ball;
    blue.colours.assign(blue.positions.size(), {0.1f, 0.2f, 0.6f, 1});
    studio.draw(blue.view(), gouraud(), state);
    state.rasterization.front_mode = state.rasterization.back_mode = PolygonMode::line;
    if (i == 1) state.rasterization.polygon_offset = {.factor = -1, .units = -2};
    blue.colours.assign(blue.positions.size(), {1, 0.9f, 0.3f, 1});
    studio.draw(blue.view(), gouraud(), state);
  }
}

/// A sphere that two planes have cut open, painted outside and in.
void user_planes_and_two_sides(Studio& studio) {
  PipelineState state = seen_from({1.2, 1.1, 2.2});
  const auto& clip = state.transform.clip_from_world;
  state.clipping.user_plane_count = 2;
  state.clipping.user_planes[0] = clip_plane_from_world({0, 0, -1, 0.45}, clip);
  state.clipping.user_planes[1] = clip_plane_from_world({-0.8, -0.6, 0, 0.5}, clip);
  state.transform.two_sided_colours = true;
  Lighting outside, inside;
  outside.diffuse = {0.9f, 0.45f, 0.1f};
  inside.diffuse = {0.1f, 0.5f, 0.8f};
  for (Lighting* light : {&outside, &inside}) {
    light->eye = {1.2f, 1.1f, 2.2f};
    light->lights[0].towards = {0.48f, 0.64f, 0.6f};
  }
  state.transform.vertex_lighting = outside;
  state.transform.back_lighting = inside;
  Mesh ball = test::sphere(24);
  ball.colours.clear();
  studio.draw(ball.view(), gouraud(), state);
}

}  // namespace

TEST_CASE("golden: points, lines and polygon modes", "[golden][exact]") {
  test::check_golden("points", test::golden_canvas(), points_of_all_sizes);
  test::check_golden("lines", test::golden_canvas(), lines_of_all_kinds);
  test::check_golden("polygon_modes", test::golden_canvas(), polygon_modes);
  test::check_golden("edge_flags", test::golden_canvas(), edge_flags);
}

TEST_CASE("golden: polygon offset, user planes and two sides", "[golden][exact]") {
  test::check_golden("polygon_offset", test::golden_canvas(), polygon_offset);
  test::check_golden("user_planes", test::golden_canvas(), user_planes_and_two_sides);
}

}  // namespace tuberia
