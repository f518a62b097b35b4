// Random scenes: every state that the machine has, drawn with probabilities that let states meet
// without drowning all pixels in rejections; and geometry that is fond of ties.

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "tests/differential/random_state.hpp"
#include "tests/differential/scene.hpp"

namespace tuberia::differential {
namespace {

using namespace oracle;

/// How a draw's vertices are strewn.
/// (grid: few places, so that edges are level, upright, shared, and run through centres and samples)
enum class Style { lattice, perspective, wild, huge, sliver, grid };

/// A number that may stand on a lattice: whole pixels, halves, units, or anywhere.
double lattice_pixels(Dice& dice, int size) {
  const int units = static_cast<int>(dice.below(size * 256 + 1024)) - 512;
  switch (dice.below(4)) {
    case 0: return std::floor(units / 256.0);
    case 1: return std::floor(units / 128.0) / 2;
    case 2: return units / 256.0;
    default: return units / 256.0 + dice.unit() / 256;
  }
}

glm::vec4 clip_from_pixels(double x, double y, double z, double w, const TargetDescription& target) {
  const double ndc_x = 2 * x / target.width - 1, ndc_y = 1 - 2 * y / target.height;
  return {static_cast<float>(ndc_x * w), static_cast<float>(ndc_y * w), static_cast<float>(z * w), static_cast<float>(w)};
}

float special_float(Dice& dice) {
  switch (dice.below(8)) {
    case 0: return std::numeric_limits<float>::infinity();
    case 1: return std::numeric_limits<float>::quiet_NaN();
    case 2: return 1e-42f;
    case 3: return -0.0f;
    case 4: return 3e38f;
    case 5: return -1e30f;
    case 6: return 1e-20f;
    default: return std::bit_cast<float>(static_cast<std::uint32_t>(dice.below(1ll << 32)));
  }
}

double random_z(Dice& dice) {
  return dice.one_in(2) ? static_cast<double>(dice.below(9) - 4) / 4 : static_cast<double>(dice.between(-1.1f, 1.1f));
}

glm::vec4 random_position(Dice& dice, Style style, const TargetDescription& target) {
  const double x = lattice_pixels(dice, target.width), y = lattice_pixels(dice, target.height);
  switch (style) {
    case Style::lattice: return clip_from_pixels(x, y, random_z(dice), 1, target);
    case Style::sliver: return clip_from_pixels(x, y * 0.02 + target.height * 0.5, random_z(dice), 1, target);
    case Style::grid: {
      const double step = dice.one_in(2) ? 4 : dice.one_in(2) ? 0.5 : 1.0 / 16;
      const double corner = dice.one_in(2) ? 4 : 4.5;
      return clip_from_pixels(corner + step * static_cast<double>(dice.below(4)), corner + step * static_cast<double>(dice.below(4)),
                              random_z(dice), dice.one_in(2) ? 1 : 2, target);
    }
    case Style::perspective: {
      const double w = dice.one_in(3) ? std::exp2(static_cast<double>(dice.below(9)) - 4) : static_cast<double>(dice.between(0.05f, 10));
      return clip_from_pixels(x, y, random_z(dice), w, target);
    }
    case Style::wild:
      return {dice.between(-3, 3), dice.between(-3, 3), dice.between(-2, 2), dice.between(-1, 2)};
    case Style::huge: {
      const float scale = std::exp2(static_cast<float>(dice.below(60)) - 10);
      return {scale * dice.between(-1, 1), scale * dice.between(-1, 1), dice.between(-1, 1), dice.one_in(4) ? scale : dice.between(-0.5f, 2)};
    }
  }
  return {0, 0, 0, 1};
}

void strew_vertices(Dice& dice, Draw& draw, const TargetDescription& target, int count) {
  const auto style = static_cast<Style>(dice.weighted({5, 4, 3, 2, 1, 3}));
  for (int i = 0; i < count; ++i) {
    InputVertex v;
    const Style own = dice.one_in(8) ? static_cast<Style>(dice.below(6)) : style;
    v.position = random_position(dice, own, target);
    if (i > 0 && dice.one_in(12)) v.position = draw.vertices[static_cast<std::size_t>(dice.below(i))].position;
    if (dice.one_in(40)) v.position = glm::vec4(0);
    if (dice.one_in(60)) v.position[static_cast<int>(dice.below(4))] = special_float(dice);
    draw.vertices.push_back(v);
  }
}

void give_attributes(Dice& dice, Draw& draw) {
  draw.has_unit_texcoords = dice.one_in(2);
  draw.has_colours = !dice.one_in(8);
  draw.has_back_colours = !dice.one_in(4);
  const bool any_range = dice.one_in(6), opaque = dice.one_in(2);
  const bool of_codes = dice.one_in(2);
  const auto intensity = [&] {
    if (any_range) return dice.between(-0.5f, 1.5f);
    return of_codes ? static_cast<float>(dice.below(256)) / 255.0f : dice.between(0, 1);
  };
  const float reach = dice.one_in(4) ? 20.0f : 1.5f;
  for (InputVertex& v : draw.vertices) {
    for (int i = 0; i < 4; ++i) {
      v.colour[i] = i == 3 && opaque ? 1 : intensity();
      v.back_colour[i] = i == 3 && opaque ? 1 : intensity();
    }
    v.texcoord = {dice.between(-reach, reach), dice.between(-reach, reach)};
    for (glm::vec4& unit : v.unit_texcoord)
      unit = {dice.between(-reach, reach), dice.between(-reach, reach), dice.between(-1, 2), dice.one_in(2) ? 1 : dice.between(0.5f, 2)};
    v.fog_coordinate = dice.between(-1, 4);
    v.edge_flag = !dice.one_in(3);
  }
}

/// Each vertex, and with it each primitive that it provokes, its own colour: then colours are the
/// primitives' numbers.
void number_primitives(Draw& draw) {
  draw.program.kind = ProgramKind::flat;
  draw.blend = {};
  draw.fog = {};
  draw.two_sided_colours = false;
  draw.has_colours = true;
  for (std::size_t i = 0; i < draw.vertices.size(); ++i) {
    const auto code = [](std::size_t c) { return static_cast<float>(c) / 255.0f; };
    draw.vertices[i].colour = {code(i % 256), code(1 + i / 256), code(255 - i % 256), 1};
  }
}

glm::mat4 matrix_near_identity(Dice& dice) {
  glm::mat4 matrix(1);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (dice.one_in(2)) matrix[column][row] += dice.between(-0.5f, 0.5f);
  return matrix;
}

void random_geometry(Dice& dice, Draw& draw, const TargetDescription& target) {
  const bool numbered = dice.one_in(3);
  const int primitives = 1 + static_cast<int>(dice.below(4));
  const int count = static_cast<int>(draw.topology) >= static_cast<int>(oracle::Topology::lines) ? 1 + 2 * primitives : 3 * primitives;
  const bool indexed = !numbered && dice.one_in(4);
  strew_vertices(dice, draw, target, indexed ? std::max(3, count / 2) : count);
  give_attributes(dice, draw);
  if (indexed)
    for (int i = 0; i < count; ++i)
      draw.indices.push_back(static_cast<std::uint32_t>(dice.below(static_cast<std::int64_t>(draw.vertices.size()))));
  if (numbered) number_primitives(draw);
  if (dice.one_in(draw.program.kind == ProgramKind::fixed_function ? 3 : 8)) {
    draw.space = PositionSpace::object;
    random_texture_coordinates(dice, draw);
    give_normals(dice, draw);
    draw.clip_from_world = matrix_near_identity(dice);
    if (dice.one_in(2)) draw.world_from_object = matrix_near_identity(dice);
  } else if (dice.one_in(8)) {
    draw.space = PositionSpace::screen;
    const int reach = dice.one_in(5) ? 1 << 23 : 0;
    for (InputVertex& v : draw.vertices) {
      const auto units = [&](int size) {
        if (reach != 0 && dice.one_in(2)) return static_cast<std::int32_t>(dice.below(2ll * reach + 1) - reach);
        return static_cast<std::int32_t>(std::floor(lattice_pixels(dice, size) * 256));
      };
      v.screen_x = units(target.width);
      v.screen_y = units(target.height);
      v.screen_depth = dice.between(0, 1);
      v.position.w = dice.one_in(2) ? 1 : dice.between(0.1f, 10);
    }
  }
  if (!numbered && draw.space != PositionSpace::screen && dice.one_in(4)) random_lighting(dice, draw);
}

TargetDescription random_target(Dice& dice) {
  TargetDescription target;
  target.width = dice.one_in(10) ? 1 + static_cast<int>(dice.below(80)) : 8 + static_cast<int>(dice.below(24));
  target.height = dice.one_in(10) ? 1 + static_cast<int>(dice.below(80)) : 8 + static_cast<int>(dice.below(24));
  target.colour = static_cast<oracle::ColourFormat>(dice.weighted({4, 2, 1, 2}));
  target.depth = static_cast<oracle::DepthFormat>(dice.below(3));
  target.has_stencil = dice.one_in(2);
  if (dice.one_in(3)) target.samples = 1 << dice.below(5);
  for (int i = 0; i < 4; ++i) target.clear_colour[i] = static_cast<float>(dice.below(256)) / 255.0f;
  target.clear_depth = dice.one_in(3) ? dice.between(0, 1) : dice.one_in(4) ? 0.0f : 1.0f;
  if (target.has_stencil) target.clear_stencil = static_cast<std::uint8_t>(dice.below(256));
  return target;
}

oracle::Clear random_clear(Dice& dice, const TargetDescription& target) {
  oracle::Clear clear;
  if (!dice.one_in(3)) clear.colour = {dice.between(-0.25f, 1.25f), dice.between(-0.25f, 1.25f), dice.between(0, 1), dice.between(0, 1)};
  if (dice.one_in(2)) clear.depth = dice.between(-0.1f, 1.1f);
  if (target.has_stencil && dice.one_in(2)) clear.stencil = static_cast<std::uint8_t>(dice.below(256));
  const auto around = [&](int size) { return static_cast<int>(dice.below(size + 8)) - 4; };
  if (!dice.one_in(4)) {
    const int left = around(target.width), top = around(target.height);
    clear.scissor = Rectangle{left, top, left + around(target.width), top + around(target.height)};
  }
  if (dice.one_in(2))
    for (bool& channel : clear.mask) channel = dice.one_in(2);
  if (dice.one_in(2)) clear.stencil_write_mask = static_cast<std::uint8_t>(dice.below(256));
  return clear;
}

/// What the pipeline's fused loops draw: triangles in the everyday ways.
void make_everyday(Dice& dice, Draw& draw) {
  draw.topology = static_cast<oracle::Topology>(dice.below(3));
  draw.front_mode = draw.back_mode = oracle::PolygonMode::fill;
  draw.fog = {};
  draw.alpha_test = oracle::Compare::always;
  draw.alpha_to_coverage = false;
  draw.stencil = {};
  draw.blend.mode = static_cast<oracle::BlendMode>(dice.below(3));
  draw.blend.logic = oracle::LogicOperation::off;
  draw.blend.mask = {true, true, true, true};
}

}  // namespace

Scene random_scene(std::uint64_t seed) {
  Dice dice(seed);
  Scene scene;
  scene.seed = seed;
  scene.target = random_target(dice);
  const bool is_everyday = dice.one_in(4);
  if (is_everyday) {
    scene.target.samples = 1;
    if (scene.target.colour == oracle::ColourFormat::rgba16f) scene.target.colour = oracle::ColourFormat::rgba8;
  }
  const int draws = 1 + static_cast<int>(dice.below(3));
  for (int i = 0; i < draws; ++i) {
    Draw draw;
    random_state(dice, draw, scene.target);
    if (is_everyday) make_everyday(dice, draw);
    random_textures(dice, draw, scene);
    random_geometry(dice, draw, scene.target);
    scene.draws.push_back(std::move(draw));
  }
  if (dice.one_in(6)) scene.clear = random_clear(dice, scene.target);
  scene.is_counted = !is_everyday && dice.one_in(2);
  scene.threads = dice.one_in(8) ? 2 : 1;
  const auto sets = supported_instruction_sets();
  scene.instruction_set = sets[static_cast<std::size_t>(dice.below(static_cast<std::int64_t>(sets.size())))];
  return scene;
}

}  // namespace tuberia::differential
