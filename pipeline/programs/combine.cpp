// What units combine: the classic environments, and what is no combination at all.

#include "pipeline/programs/combine.hpp"

#include <string>

#include "pipeline/refusal.hpp"

namespace tuberia {
namespace {

constexpr CombineArgument kTexture{CombineSource::texture}, kPrevious{CombineSource::previous}, kConstant{CombineSource::constant};
constexpr CombineArgument kTextureAlpha{CombineSource::texture, CombineOperand::alpha};

constexpr Combine kProduct{.function = CombineFunction::modulate, .argument = {kPrevious, kTexture, kConstant}};

bool in_unit(float x) { return x >= 0 && x <= 1; }

bool is_known(const Combine& combine) {
  for (const CombineArgument& argument : combine.argument)
    if (argument.source > CombineSource::previous || argument.operand > CombineOperand::one_minus_alpha) return false;
  return combine.function <= CombineFunction::dot3_rgba;
}

bool is_scale(int scale) { return scale == 1 || scale == 2 || scale == 4; }

Refusal refusal_of_unit(const TextureUnit& unit) {
  if (!is_known(unit.colour) || !is_known(unit.alpha)) return Error{"a function, source or operand is none of its enumeration"};
  if (!is_scale(unit.colour.scale)) return Error{"the colour's scale is " + std::to_string(unit.colour.scale) + ", but can be 1, 2 or 4"};
  if (!is_scale(unit.alpha.scale)) return Error{"the alpha's scale is " + std::to_string(unit.alpha.scale) + ", but can be 1, 2 or 4"};
  if (unit.alpha.function >= CombineFunction::dot3_rgb) return Error{"dot3 is no function of alpha"};
  for (const float channel : {unit.constant.r, unit.constant.g, unit.constant.b, unit.constant.a})
    if (!in_unit(channel)) return Error{"the constant has a channel of " + words_of(channel) + ", outside [0, 1]"};
  if (const char* refusal = refusal_of(unit.sampler)) return Error{refusal};
  return {};
}

}  // namespace

CombinePair replace_environment() noexcept {
  const Combine texel{.function = CombineFunction::replace, .argument = {kTexture, kPrevious, kConstant}};
  return {texel, texel};
}

CombinePair modulate_environment() noexcept { return {kProduct, kProduct}; }

CombinePair decal_environment() noexcept {
  return {{.function = CombineFunction::interpolate, .argument = {kTexture, kPrevious, kTextureAlpha}},
          {.function = CombineFunction::replace, .argument = {kPrevious, kTexture, kConstant}}};
}

CombinePair blend_environment() noexcept {
  return {{.function = CombineFunction::interpolate, .argument = {kConstant, kPrevious, kTexture}}, kProduct};
}

CombinePair add_environment() noexcept {
  return {{.function = CombineFunction::add, .argument = {kPrevious, kTexture, kConstant}}, kProduct};
}

Refusal refusal_of(const FixedFunctionUniforms& uniforms) {
  for (std::size_t number = 0; number < uniforms.units.size(); ++number)
    if (uniforms.units[number].texture)
      if (const Refusal refusal = refusal_of_unit(uniforms.units[number]))
        return Error{"unit " + std::to_string(number) + ": " + refusal->message};
  return {};
}

}  // namespace tuberia
