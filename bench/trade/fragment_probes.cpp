// Probes of what is interpolated, shaded and stored.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "bench/trade/closed_forms.hpp"
#include "bench/trade/lit_program.hpp"
#include "bench/trade/probe_recipe.hpp"
#include "bench/trade/probes.hpp"
#include "pipeline/programs/programs.hpp"

namespace tuberia::bench::trade {
namespace {

constexpr Rgba32F kBlack{0, 0, 0, 1};

/// A picture each of whose columns has one colour.
template <class Intensity>
Scene::Picture columns(int width, int height, Intensity&& intensity) {
  Scene::Picture picture(width, height);
  for (int x = 0; x < width; ++x) {
    const auto value = static_cast<float>(intensity((x + 0.5) / width));
    for (int y = 0; y < height; ++y) picture.at(x, y) = {value, value, value, 1};
  }
  return picture;
}

double largest_difference(const Scene::Picture& picture, const Scene::Picture& ideal) {
  double largest = 0;
  for (std::size_t i = 0; i < ideal.pixels().size(); ++i)
    largest = std::max(largest, static_cast<double>(std::abs(picture.pixels()[i].r - ideal.pixels()[i].r)));
  return largest;
}

/// All of clip space, one colour and one w at the left and another at the right.
Shape filling_rectangle(const glm::vec4& left, const glm::vec4& right, float w_left = 1, float w_right = 1) {
  Shape shape;
  shape.clip_positions = {{-w_left, -w_left, 0, w_left},
                          {w_right, -w_right, 0, w_right},
                          {w_right, w_right, 0, w_right},
                          {-w_left, w_left, 0, w_left}};
  shape.colours = {left, right, right, left};
  shape.indices = {0, 1, 2, 0, 2, 3};
  return shape;
}

constexpr int kTexels = 256;

constexpr int kHighlightWidth = 255, kHighlightHeight = 64;  // odd: one column is the middle

Lighting only_a_highlight(float shininess) {
  Lighting light;
  light.ambient = light.diffuse = glm::vec3(0);
  light.specular = glm::vec3(1);
  light.shininess = shininess;
  light.eye = {0, 0, 1e8f};
  light.lights[0].towards = {0, 0, 1};
  return light;
}

}  // namespace

Scene receding_texels(double w_right) {
  char name[48];
  std::snprintf(name, sizeof name, "w from 1 to %g", w_right);
  auto shape =
      std::make_shared<Shape>(filling_rectangle(glm::vec4(0), glm::vec4(kTexels), 1, static_cast<float>(w_right)));
  Scene scene{.name = name,
              .what = "256 texels over 256 pixels, receding to the right",
              .recipe = probe_recipe(kTexels, kTexels, ColourFormat::rgba32f),
              .build = [shape](const Recipe& recipe) -> Result<Frame> {
                auto frame = Frame::create(recipe, kBlack);
                if (!frame) return frame.error();
                PipelineState state = recipe.state;
                state.depth = kDepthOff;
                frame->add(shape, gouraud(), state);
                return frame;
              }};
  scene.ideal = [w_right] {
    return columns(kTexels, kTexels, [&](double t) { return kTexels * perspective_coordinate(t, w_right); });
  };
  scene.error = largest_difference;
  scene.is_picture = false;
  return scene;
}

Scene highlight_between_normals(double lean_degrees, float shininess) {
  char name[64];
  std::snprintf(name, sizeof name, "normals +-%g deg, n = %g", lean_degrees, static_cast<double>(shininess));
  const double lean = glm::radians(lean_degrees);
  auto shape = std::make_shared<Shape>();
  const auto x = static_cast<float>(std::sin(lean)), z = static_cast<float>(std::cos(lean));
  add_rectangle(*shape, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});
  shape->normals = {{-x, 0, z}, {x, 0, z}, {-x, 0, z}, {x, 0, z}};
  Scene scene{.name = name,
              .what = "a highlight in the middle of a square whose normals lean outwards at its sides",
              .recipe = probe_recipe(kHighlightWidth, kHighlightHeight, ColourFormat::rgba32f),
              .build = [shape, shininess](const Recipe& recipe) -> Result<Frame> {
                auto frame = Frame::create(recipe, kBlack);
                if (!frame) return frame.error();
                PipelineState state = recipe.state;
                FragmentProgram program = lit_program(recipe, only_a_highlight(shininess), nullptr, state);
                frame->add(shape, std::move(program), state);
                return frame;
              }};
  // The interpolated normal leans by atan(s tan(lean)), s from -1 to 1; light and eye stand straight ahead.
  scene.ideal = [lean, shininess] {
    return columns(kHighlightWidth, kHighlightHeight, [&](double t) {
      return std::pow(std::cos(std::atan((2 * t - 1) * std::tan(lean))), static_cast<double>(shininess));
    });
  };
  return scene;
}

Scene intensity_ramp() {
  constexpr int kWidth = 1000, kHeight = 64;  // no power of two, whose fractions halves store exactly
  auto shape = std::make_shared<Shape>(filling_rectangle({0, 0, 0, 1}, {1, 1, 1, 1}));
  Scene scene{.name = "ramp from 0 to 1",
              .what = "all intensities, left to right",
              .recipe = probe_recipe(kWidth, kHeight, ColourFormat::rgba32f),
              .build = [shape](const Recipe& recipe) -> Result<Frame> {
                auto frame = Frame::create(recipe, kBlack);
                if (!frame) return frame.error();
                PipelineState state = recipe.state;
                state.depth = kDepthOff;
                frame->add(shape, gouraud(), state);
                return frame;
              }};
  scene.ideal = [] { return columns(kWidth, kHeight, [](double t) { return t; }); };
  scene.signal = Signal::linear;
  return scene;
}

Scene thin_layers(int layers) {
  constexpr int kSize = 128;
  auto shape = std::make_shared<Shape>();
  for (int i = 0; i < layers; ++i) add_clip_rectangle(*shape, {-1, -1}, {1, 1}, 0, {0, 0, 0, 1.0f / 255});
  Scene scene{.name = std::to_string(layers) + " layers of alpha 1/255",
              .what = "black over white, each layer as thin as a code",
              .recipe = probe_recipe(kSize, kSize, ColourFormat::rgba32f),
              .build = [shape](const Recipe& recipe) -> Result<Frame> {
                auto frame = Frame::create(recipe, {1, 1, 1, 1});
                if (!frame) return frame.error();
                PipelineState state = recipe.state;
                state.depth = kDepthOff;
                state.blend.mode = BlendMode::source_over;
                frame->add(shape, flat(), state);
                return frame;
              }};
  scene.ideal = [layers] { return columns(kSize, kSize, [&](double) { return std::pow(254.0 / 255, layers); }); };
  scene.signal = Signal::linear;
  return scene;
}

}  // namespace tuberia::bench::trade
