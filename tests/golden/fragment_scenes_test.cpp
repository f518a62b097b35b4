// Pictures of everything between the fragment program and the pixel.

#include <catch2/catch.hpp>

#include "tests/golden/golden_scene.hpp"

namespace tuberia {

namespace {

using test::Mesh;
using test::Studio;

Mesh square(float x, float y, float size, glm::vec4 colour) {
  return test::rectangle({x, y, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, 1}, 1, colour);
}

/// Over the whole cell: colour from left to right, alpha from below to above.
Mesh ramp(glm::vec4 left, glm::vec4 right, float alpha_below, float alpha_above) {
  Mesh mesh = square(-1, -1, 2, glm::vec4(1));
  mesh.colours = {left, right, right, left};
  for (const std::size_t i : {0u, 1u}) mesh.colours[i].a = alpha_below;
  for (const std::size_t i : {2u, 3u}) mesh.colours[i].a = alpha_above;
  return mesh;
}

/// Overlapping squares count themselves in the stencil buffer, then each count gets its colour; on the
/// right the two sides of a ring's faces count up and down, as shadow volumes do.
void stencil_counts(Studio& studio) {
  PipelineState count;
  count.depth = kDepthOff;
  count.blend.write = false;
  count.stencil.enabled = true;
  count.stencil.front.pass = count.stencil.back.pass = StencilOperation::increment;
  count.viewport.viewport = Viewport{0, 0, 80, 120};
  for (int i = 0; i < 5; ++i) studio.draw(square(-0.9f + 0.2f * static_cast<float>(i), -0.8f + 0.18f * static_cast<float>(i), 0.85f, glm::vec4(1)).view(), flat(), count);

  count.viewport.viewport = Viewport{80, 0, 80, 120};
  count.transform.clip_from_world = test::clip_from_world({0.5, 1, 2.4}, 80.0 / 120.0);
  count.stencil.front.pass = StencilOperation::increment_wrap;
  count.stencil.back.pass = StencilOperation::decrement_wrap;
  count.clipping.user_plane_count = 1;
  count.clipping.user_planes[0] = clip_plane_from_world({0, -1, 0, 0.3}, count.transform.clip_from_world);
  studio.draw(test::sphere(16).view(), flat(), count);

  PipelineState paint;
  paint.depth = kDepthOff;
  paint.stencil.enabled = true;
  paint.stencil.front.test = paint.stencil.back.test = Compare::equal;
  const glm::vec4 colours[6] = {{0.9f, 0.9f, 0.8f, 1}, {0.9f, 0.7f, 0.2f, 1}, {0.9f, 0.4f, 0.1f, 1}, {0.7f, 0.1f, 0.1f, 1}, {0.4f, 0, 0.3f, 1}, {0.2f, 0.5f, 0.9f, 1}};
  for (int i = 0; i < 6; ++i) {
    paint.stencil.front.reference = static_cast<std::uint8_t>(i < 5 ? i + 1 : 255);
    studio.draw(square(-1, -1, 2, colours[i]).view(), gouraud(), paint);
  }
}

/// What each comparison leaves of a ramp of alpha against 1/2; equality hits a step.
void alpha_tests(Studio& studio) {
  PipelineState state;
  state.alpha_test.reference = 0.5f;
  for (int i = 0; i < 8; ++i) {
    state.viewport.viewport = test::grid_cell(i % 4, i / 4, 4, 2);
    state.alpha_test.test = static_cast<Compare>(i);
    studio.draw(ramp({0.9f, 0.3f, 0.1f, 1}, {0.2f, 0.8f, 0.3f, 1}, 0, 1).view(), gouraud(), state);
    Mesh step = square(-0.5f, -0.5f, 0.8f, {0.3f, 0.4f, 0.9f, 0.5f});
    for (glm::vec3& p : step.positions) p.z = -0.5f;
    studio.draw(step.view(), gouraud(), state);
  }
}

/// A corridor floor three times, in linear, exponential and squared exponential fog.
void fog_modes(Studio& studio) {
  PipelineState state;
  const auto texture = test::texture_of(test::checkerboard(32, 16, {240, 230, 200, 255}, {130, 40, 30, 255}), TextureEncoding::srgb);
  const FogState fogs[3] = {{.mode = FogMode::linear, .colour = {0.4f, 0.5f, 0.6f, 1}, .start = 2, .end = 14},
                            {.mode = FogMode::exp, .colour = {0.4f, 0.5f, 0.6f, 1}, .density = 0.15f},
                            {.mode = FogMode::exp2, .colour = {0.4f, 0.5f, 0.6f, 1}, .density = 0.12f}};
  for (int i = 0; i < 3; ++i) {
    state.viewport.viewport = test::grid_cell(i, 0, 3, 1);
    state.transform.clip_from_world = test::clip_from_world({0, 0.9, 3}, 51.0 / 118.0);
    state.fog = fogs[i];
    studio.draw(test::rectangle({-20, -1, -40}, {0, 0, 44}, {40, 0, 0}, {0, 1, 0}, 20).view(), textured({.texture = texture, .sampler = {}}), state);
    for (int k = 0; k < 5; ++k) {
      state.transform.world_from_object = translation({k % 2 == 0 ? -0.5 : 0.5, -0.4, 0.5 - 2.5 * k});
      Mesh ball = test::sphere(10);
      for (glm::vec3& p : ball.positions) p *= 0.5f;
      studio.draw(ball.view(), gouraud(), state);
    }
    state.transform.world_from_object = glm::mat4(1);
  }
}

/// Rows: add, subtract, reverse subtract, min, max; columns: pairs of factors.
void blend_functions(Studio& studio) {
  const BlendFactor pairs[8][2] = {{BlendFactor::one, BlendFactor::one}, {BlendFactor::source_alpha, BlendFactor::one_minus_source_alpha},
                                   {BlendFactor::destination_colour, BlendFactor::zero}, {BlendFactor::one_minus_destination_colour, BlendFactor::one},
                                   {BlendFactor::constant_colour, BlendFactor::one_minus_constant_alpha}, {BlendFactor::source_alpha_saturate, BlendFactor::one},
                                   {BlendFactor::destination_alpha, BlendFactor::one_minus_destination_alpha}, {BlendFactor::zero, BlendFactor::source_colour}};
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 8; ++column) {
      PipelineState state;
      state.depth = kDepthOff;
      state.viewport.viewport = test::grid_cell(column, row, 8, 5);
      studio.draw(ramp({0.9f, 0.2f, 0.1f, 1}, {0.1f, 0.3f, 0.8f, 1}, 0.9f, 0.3f).view(), gouraud(), state);
      state.blend = {.mode = BlendMode::function, .constant = {0.7f, 0.5f, 0.2f, 0.4f}};
      state.blend.colour = {pairs[column][0], pairs[column][1], static_cast<BlendEquation>(row)};
      state.blend.alpha = {BlendFactor::one, BlendFactor::one_minus_source_alpha, BlendEquation::add};
      Mesh over = square(-0.7f, -0.7f, 1.4f, glm::vec4(1));
      over.colours = {{0.2f, 0.8f, 0.2f, 0}, {0.9f, 0.9f, 0.1f, 0.2f}, {0.8f, 0.3f, 0.9f, 1}, {0.1f, 0.6f, 0.7f, 0.8f}};
      studio.draw(over.view(), gouraud(), state);
    }
}

/// The sixteen operations on overlapping squares.
void logic_operations(Studio& studio) {
  for (int i = 0; i < 16; ++i) {
    PipelineState state;
    state.depth = kDepthOff;
    state.viewport.viewport = test::grid_cell(i % 4, i / 4, 4, 4);
    studio.draw(square(-0.9f, -0.9f, 1.3f, {0.8f, 0.35f, 0.15f, 1}).view(), gouraud(), state);
    state.blend.logic = static_cast<LogicOperation>(i + 1);
    state.blend.mask.alpha = false;
    studio.draw(square(-0.4f, -0.4f, 1.3f, {0.2f, 0.6f, 0.45f, 1}).view(), gouraud(), state);
  }
}

/// White over grey, channel by channel; and what two scissored, masked clears leave.
void colour_masks_and_clears(Studio& studio) {
  const ColourMask masks[8] = {{}, {true, false, false, true}, {false, true, false, true}, {false, false, true, true},
                               {false, true, true, true}, {true, false, true, true}, {true, true, false, true}, {false, false, false, true}};
  for (int i = 0; i < 8; ++i) {
    PipelineState state;
    state.depth = kDepthOff;
    state.viewport.viewport = test::grid_cell(i % 4, i / 4, 4, 2);
    studio.draw(square(-1, -1, 2, {0.2f, 0.2f, 0.2f, 1}).view(), gouraud(), state);
    state.blend.mask = masks[i];
    studio.draw(square(-0.6f, -0.6f, 1.2f, glm::vec4(1)).view(), gouraud(), state);
  }
  const auto clear = [&](const ClearCommand& command) { REQUIRE(studio.pipeline().clear(studio.target(), command)); };
  clear({.colour = Rgba32F{1, 0.6f, 0, 1}, .scissor = PixelRect{20, 50, 90, 70}, .colour_mask = {.green = false}});
  clear({.colour = Rgba32F{0, 0.7f, 1, 1}, .scissor = PixelRect{70, 40, 140, 62}, .colour_mask = {.red = false}});
}

Mesh star() {
  Mesh mesh;
  const float ring[10][2] = {{0, 0.95f}, {0.21f, 0.29f}, {0.9f, 0.29f}, {0.34f, -0.11f}, {0.56f, -0.77f}, {0, -0.36f}, {-0.56f, -0.77f}, {-0.34f, -0.11f}, {-0.9f, 0.29f}, {-0.21f, 0.29f}};
  mesh.positions.push_back({0, 0, 0});
  mesh.colours.push_back({1, 1, 0.8f, 1});
  for (int i = 0; i <= 10; ++i) {
    mesh.positions.push_back({ring[i % 10][0], ring[i % 10][1], 0});
    mesh.colours.push_back(i % 2 == 0 ? glm::vec4{0.9f, 0.5f, 0.1f, 1} : glm::vec4{0.8f, 0.1f, 0.3f, 1});
  }
  return mesh;
}

/// A star, thin lines and a point, each pixel shown three times as large.
Image<Rgba8> magnified(Studio& studio) {
  PipelineState state;
  state.assembly.topology = Topology::triangle_fan;
  studio.draw(star().view(), gouraud(), state);
  Mesh lines;
  lines.positions = {{-0.95f, 0.9f, 0}, {-0.2f, 0.55f, 0}, {0.9f, 0.95f, 0}, {0.6f, 0.2f, 0}};
  lines.colours.assign(4, {0.6f, 0.9f, 1, 1});
  state.assembly.topology = Topology::lines;
  state.rasterization.line.width_pixels = 1.5f;
  studio.draw(lines.view(), gouraud(), state);
  state.assembly.topology = Topology::points;
  state.rasterization.point = {.size_pixels = 7.5f, .round = true};
  lines.positions = {{0.7f, -0.7f, 0}, {-0.8f, -0.5f, 0}};
  lines.colours.resize(2);
  studio.draw(lines.view(), gouraud(), state);

  const Image<Rgba8> small = studio.target().colour_image();
  Image<Rgba8> large(small.width() * 3, small.height() * 3);
  for (int y = 0; y < large.height(); ++y)
    for (int x = 0; x < large.width(); ++x) large.at(x, y) = small.at(x / 3, y / 3);
  return large;
}

/// Leaves with soft edges, with and without alpha to coverage.
void alpha_to_coverage(Studio& studio) {
  for (int i = 0; i < 2; ++i) {
    PipelineState state;
    state.viewport.viewport = test::grid_cell(i, 0, 2, 1);
    state.multisampling.alpha_to_coverage = i == 1;
    for (int k = 0; k < 3; ++k) {
      Mesh leaf = ramp({0.2f, 0.7f, 0.2f, 1}, {0.7f, 0.8f, 0.1f, 1}, 0, 1);
      for (glm::vec3& p : leaf.positions) p = {p.x * 0.4f - 0.4f + 0.4f * static_cast<float>(k), p.y * 0.6f + 0.2f - 0.2f * static_cast<float>(k), 0.3f - 0.3f * static_cast<float>(k)};
      studio.draw(leaf.view(), gouraud(), state);
    }
  }
}

/// Light beyond white, added up and darkened again: only targets of floats keep it.
void light_beyond_white(Studio& studio) {
  PipelineState state;
  state.depth = kDepthOff;
  state.blend.mode = BlendMode::additive;
  for (int i = 0; i < 6; ++i) studio.draw(square(-0.9f + 0.15f * static_cast<float>(i), -0.9f + 0.12f * static_cast<float>(i), 1.1f, {0.5f, 0.3f, 0.2f, 0}).view(), gouraud(), state);
  state.blend = {.mode = BlendMode::function, .colour = {BlendFactor::zero, BlendFactor::constant_colour}, .alpha = {BlendFactor::one, BlendFactor::zero},
                 .constant = {0.4f, 0.4f, 0.4f, 1}};
  studio.draw(square(-1, -1, 2, glm::vec4(1)).view(), gouraud(), state);
}

}  // namespace

TEST_CASE("golden: stencil, alpha test and fog", "[golden][exact]") {
  test::Canvas with_stencil = test::golden_canvas();
  with_stencil.stencil = true;
  test::check_golden("stencil", with_stencil, stencil_counts);
  test::check_golden("alpha_test", test::golden_canvas(), alpha_tests);
  test::check_golden("fog", test::golden_canvas(), fog_modes);
}

TEST_CASE("golden: blend functions, logic operations and masks", "[golden][exact]") {
  test::Canvas linear = test::golden_canvas();
  linear.colour = ColourFormat::rgba8;
  test::check_golden("blend_functions", test::golden_canvas(), blend_functions);
  test::check_golden("logic_operations", linear, logic_operations);
  test::check_golden("colour_masks", test::golden_canvas(), colour_masks_and_clears);
  linear.colour = ColourFormat::rgba16f;
  test::check_golden("half_floats", linear, light_beyond_white);
}

TEST_CASE("golden: multisampling", "[golden][exact]") {
  for (const int samples : {1, 2, 4, 8, 16}) {
    test::Canvas canvas = test::golden_canvas();
    canvas.width = canvas.height = 48;
    canvas.samples = samples;
    test::check_golden(("samples_" + std::to_string(samples)).c_str(), canvas, magnified);
  }
  test::Canvas canvas = test::golden_canvas();
  canvas.samples = 8;
  test::check_golden("alpha_to_coverage", canvas, alpha_to_coverage);
}

}  // namespace tuberia
