#include <algorithm>

#include "tests/differential/random_state.hpp"

namespace tuberia::differential {
namespace {

using oracle::Combine;

std::shared_ptr<const oracle::Texture> random_texture(Dice& dice, oracle::TextureKind kind) {
  oracle::Texture texture;
  const auto size = [&] { return 1 + static_cast<int>(dice.below(8)); };
  texture.kind = kind;
  texture.width = size();
  if (kind != oracle::TextureKind::one_dimensional) texture.height = size();
  if (kind == oracle::TextureKind::three_dimensional) texture.slices = size();
  if (kind == oracle::TextureKind::cube) {
    texture.height = texture.width;
    texture.slices = 6;
  }
  texture.is_depth = kind == oracle::TextureKind::two_dimensional && dice.one_in(4);
  const bool is_float = !texture.is_depth && kind == oracle::TextureKind::two_dimensional && dice.one_in(5);
  texture.is_srgb = !texture.is_depth && !is_float && dice.one_in(2);
  texture.has_mipmaps = !texture.is_depth && dice.one_in(2);
  for (int i = 0; i < texture.width * texture.height * texture.slices; ++i) {
    const auto code = [&] { return static_cast<std::uint8_t>(dice.below(256)); };
    if (is_float) texture.floats.push_back({dice.between(-1, 2), dice.between(0, 3), dice.between(0, 1), dice.between(0, 1)});
    else if (texture.is_depth) texture.depths.push_back(dice.between(0, 1));
    else texture.texels.push_back({code(), code(), code(), code()});
  }
  complete(texture);
  return std::make_shared<const oracle::Texture>(texture);
}

oracle::Sampler random_sampler(Dice& dice, const oracle::Texture& texture) {
  oracle::Sampler sampler;
  sampler.texels = static_cast<oracle::TexelFilter>(dice.below(2));
  if (texture.has_mipmaps) sampler.mipmaps = static_cast<oracle::MipmapFilter>(dice.below(3));
  for (oracle::Wrap* wrap : {&sampler.wrap_u, &sampler.wrap_v, &sampler.wrap_w}) *wrap = static_cast<oracle::Wrap>(dice.below(4));
  for (int i = 0; i < 4; ++i) sampler.border[i] = dice.between(0, 1);
  if (dice.one_in(3)) sampler.lod_bias = dice.between(-2, 2);
  if (dice.one_in(4)) sampler.min_lod = dice.between(0, 2);
  if (dice.one_in(4)) sampler.max_lod = sampler.min_lod + dice.between(0, 2);
  if (dice.one_in(4)) sampler.max_anisotropy = dice.one_in(2) ? dice.between(1, 16) : static_cast<float>(1 << dice.below(5));
  if (dice.one_in(5)) sampler.weights = oracle::FilterWeights::eight_bits;
  if (dice.one_in(3)) sampler.footprint = static_cast<oracle::FootprintForm>(dice.below(3));
  if (texture.is_depth && !dice.one_in(3)) sampler.compare = static_cast<oracle::Compare>(dice.below(8));
  return sampler;
}

Combine random_combine(Dice& dice, bool is_alpha) {
  Combine combine;
  if (dice.one_in(3)) return combine;
  combine.function = static_cast<oracle::CombineFunction>(dice.below(is_alpha ? 6 : 8));
  for (oracle::CombineArgument& argument : combine.argument)
    argument = {static_cast<oracle::CombineSource>(dice.below(4)), static_cast<oracle::CombineOperand>(dice.below(4))};
  combine.scale = 1 << dice.below(3);
  return combine;
}

}  // namespace

void random_textures(Dice& dice, oracle::Draw& draw, Scene& scene) {
  oracle::Program& program = draw.program;
  const auto made = [&](oracle::TextureKind kind) {
    scene.textures.push_back(random_texture(dice, kind));
    return scene.textures.back().get();
  };
  if (program.kind == oracle::ProgramKind::textured || program.kind == oracle::ProgramKind::textured_gouraud) {
    do program.texture = made(oracle::TextureKind::two_dimensional);
    while (program.texture->is_depth);
    program.sampler = random_sampler(dice, *program.texture);
  }
  if (program.kind != oracle::ProgramKind::fixed_function) return;
  for (oracle::TextureUnit& unit : program.units) {
    if (dice.one_in(2)) continue;
    unit.texture = made(static_cast<oracle::TextureKind>(dice.weighted({1, 3, 1, 2})));
    unit.sampler = random_sampler(dice, *unit.texture);
    unit.colour = random_combine(dice, false);
    unit.alpha = random_combine(dice, true);
    for (int i = 0; i < 4; ++i) unit.constant[i] = dice.between(0, 1);
  }
}

void random_texture_coordinates(Dice& dice, oracle::Draw& draw) {
  using oracle::TexCoordSource;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (dice.one_in(2)) draw.view_from_world[i][j] = dice.between(-1, 1);
  if (dice.one_in(10)) draw.view_from_world[2] = draw.view_from_world[static_cast<int>(dice.below(2))];  // without inverse
  for (oracle::TexCoordUnit& unit : draw.texcoord_units) {
    // Maps mostly make all the coordinates that they can.
    const auto common = static_cast<TexCoordSource>(dice.below(6));
    for (std::size_t i = 0; i < 3; ++i) {
      const auto source = dice.one_in(4) ? static_cast<TexCoordSource>(dice.below(6)) : common;
      if (i < 2 || source != TexCoordSource::sphere_map) unit.source[i] = source;
      unit.plane[i] = {dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)};
    }
    if (dice.one_in(2)) continue;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j) unit.matrix[i][j] = dice.between(-1, 1);
  }
}

}  // namespace tuberia::differential
