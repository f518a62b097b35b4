#include "tests/differential/random_state.hpp"

#include <cmath>

namespace tuberia::differential {
namespace {

using namespace oracle;

template <class Choice>
Choice any(Dice& dice, int choices) {
  return static_cast<Choice>(dice.below(choices));
}

void random_clipping(Dice& dice, Draw& draw) {
  draw.volume = any<oracle::ClipVolume>(dice, 2);
  if (!dice.one_in(4)) return;
  const std::int64_t planes = dice.one_in(6) ? 8 : 1 + dice.below(2);
  for (std::int64_t i = 0; i < planes; ++i) {
    glm::dvec4 plane{dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1), dice.between(-0.3f, 1)};
    if (dice.one_in(3)) plane = {static_cast<double>(dice.below(3) - 1), static_cast<double>(dice.below(3) - 1), 0, static_cast<double>(dice.below(3)) / 2};
    draw.user_planes.push_back(plane);
  }
}

void random_viewport(Dice& dice, Draw& draw, const TargetDescription& target) {
  const int width = target.width, height = target.height;
  const auto around = [&](int size) { return static_cast<int>(dice.below(size + 8)) - 4; };
  if (dice.one_in(4)) draw.viewport = oracle::Viewport{around(width), around(height), static_cast<int>(dice.below(width + 9)), static_cast<int>(dice.below(height + 9))};
  else if (dice.one_in(4)) draw.viewport = oracle::Viewport{around(width) / 2, around(height) / 2, width, height};
  else if (dice.one_in(20)) draw.viewport = oracle::Viewport{-16384, 3 - 16384, 16384, 16384};
  if (dice.one_in(4)) {
    draw.scissor = Rectangle{around(width), around(height), 0, 0};
    draw.scissor->right = draw.scissor->left + static_cast<int>(dice.below(width + 5));
    draw.scissor->bottom = draw.scissor->top + static_cast<int>(dice.below(height + 5));
  }
  if (dice.one_in(4)) {
    draw.near_depth = dice.one_in(2) ? dice.between(0, 1) : static_cast<float>(dice.below(3)) / 2;
    draw.far_depth = dice.one_in(2) ? dice.between(0, 1) : static_cast<float>(dice.below(3)) / 2;
  }
}

void random_polygons(Dice& dice, Draw& draw) {
  draw.front_face = any<oracle::Winding>(dice, 2);
  if (dice.one_in(3)) draw.cull = any<oracle::CullFace>(dice, 3);
  draw.two_sided_colours = dice.one_in(4);
  if (dice.one_in(3)) {
    draw.front_mode = any<oracle::PolygonMode>(dice, 3);
    draw.back_mode = any<oracle::PolygonMode>(dice, 3);
  }
  if (!dice.one_in(4)) return;
  oracle::PolygonOffset& offset = draw.polygon_offset;
  if (dice.one_in(2)) offset.factor = dice.between(-2, 2);
  if (dice.one_in(2)) offset.units = std::exp2(static_cast<float>(dice.below(20))) * dice.between(-1, 1);
  if (dice.one_in(4)) offset.clamp = dice.between(-0.01f, 0.01f);
  offset.fill = !dice.one_in(4);
  offset.line = !dice.one_in(4);
  offset.point = !dice.one_in(4);
}

void random_points_and_lines(Dice& dice, Draw& draw) {
  if (!dice.one_in(3)) draw.point_size_pixels = dice.one_in(2) ? dice.between(0.01f, 12) : static_cast<float>(1 + dice.below(6));
  if (dice.one_in(30)) draw.point_size_pixels = 300;
  draw.round_points = dice.one_in(2);
  if (dice.one_in(2)) draw.line_width_pixels = dice.one_in(2) ? dice.between(1, 6) : static_cast<float>(1 + dice.below(5));
  if (dice.one_in(3)) draw.stipple = Stipple{static_cast<std::uint16_t>(dice.below(65536)), dice.one_in(2) ? 1 : 1 + static_cast<int>(dice.below(256))};
}

void random_program(Dice& dice, Draw& draw) {
  draw.program.kind = static_cast<ProgramKind>(dice.weighted({2, 4, 2, 1, 4}));
  draw.flat_shading = dice.one_in(5);
  draw.program.cut_out = dice.one_in(3);
  draw.program.alpha_cutoff = dice.between(0, 1);
  for (int i = 0; i < 4; ++i) draw.program.tint[i] = dice.one_in(2) ? 1 : dice.between(0, 1);
  if (dice.one_in(4)) {
    draw.fog.mode = any<oracle::FogMode>(dice, 4);
    for (int i = 0; i < 4; ++i) draw.fog.colour[i] = dice.between(0, 1);
    draw.fog.density = dice.between(0, 2);
    draw.fog.start = dice.between(-1, 2);
    draw.fog.end = draw.fog.start + (dice.one_in(4) ? dice.between(-3, -0.01f) : dice.between(0.01f, 3));
    draw.has_fog_coordinates = dice.one_in(2);
  }
}

void random_tests(Dice& dice, Draw& draw, const TargetDescription& target) {
  if (dice.one_in(5)) {
    draw.alpha_test = any<oracle::Compare>(dice, 8);
    draw.alpha_reference = dice.one_in(2) ? dice.between(0, 1) : static_cast<float>(dice.below(3)) / 2;
  }
  draw.alpha_to_coverage = dice.one_in(6);
  draw.depth_test = dice.one_in(2) ? oracle::Compare::always : any<oracle::Compare>(dice, 8);
  draw.depth_write = !dice.one_in(4);
  if (!target.has_stencil || dice.one_in(4)) return;
  draw.stencil.enabled = true;
  for (oracle::StencilFace* face : {&draw.stencil.front, &draw.stencil.back}) {
    const auto mask = [&] { return static_cast<std::uint8_t>(dice.one_in(2) ? 255 : dice.below(256)); };
    face->test = dice.one_in(2) ? oracle::Compare::always : any<oracle::Compare>(dice, 8);
    face->reference = static_cast<std::uint8_t>(dice.below(256));
    face->read_mask = mask();
    face->write_mask = mask();
    face->fail = any<oracle::StencilOperation>(dice, 8);
    face->depth_fail = any<oracle::StencilOperation>(dice, 8);
    face->pass = any<oracle::StencilOperation>(dice, 8);
  }
}

void random_blending(Dice& dice, Draw& draw, const TargetDescription& target) {
  draw.blend.mode = static_cast<oracle::BlendMode>(dice.weighted({3, 2, 2, 4}));
  draw.blend.write = !dice.one_in(15);
  for (oracle::BlendFunction* function : {&draw.blend.colour, &draw.blend.alpha}) {
    function->source = any<oracle::BlendFactor>(dice, 15);
    function->destination = any<oracle::BlendFactor>(dice, 15);
    function->equation = any<oracle::BlendEquation>(dice, 5);
  }
  const bool unclamped = dice.one_in(4);
  for (int i = 0; i < 4; ++i) draw.blend.constant[i] = unclamped ? dice.between(-1, 2) : dice.between(0, 1);
  if (target.colour == oracle::ColourFormat::rgba8 && dice.one_in(6)) draw.blend.logic = any<oracle::LogicOperation>(dice, 17);
  if (dice.one_in(6))
    for (bool& channel : draw.blend.mask) channel = dice.one_in(2);
}

/// What trades accuracy for speed.
void random_trades(Dice& dice, Draw& draw, const TargetDescription& target) {
  if (dice.one_in(6)) draw.subpixel_bits = static_cast<int>(dice.below(9));
  if (dice.one_in(4)) draw.perspective = any<oracle::PerspectiveCorrection>(dice, 5);
  draw.fog.per_vertex = dice.one_in(3);
  if (target.samples == 1 && dice.one_in(6)) draw.edge_arithmetic = any<oracle::EdgeArithmetic>(dice, 4);
}

}  // namespace

void random_state(Dice& dice, Draw& draw, const TargetDescription& target) {
  draw.topology = static_cast<oracle::Topology>(dice.weighted({6, 3, 3, 3, 2, 2, 3}));
  random_clipping(dice, draw);
  random_viewport(dice, draw, target);
  random_polygons(dice, draw);
  random_points_and_lines(dice, draw);
  random_program(dice, draw);
  random_tests(dice, draw, target);
  random_blending(dice, draw, target);
  random_trades(dice, draw, target);
}

}  // namespace tuberia::differential
