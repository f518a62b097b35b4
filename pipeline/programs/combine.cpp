// What units combine: the classic environments, and what is no combination at all.

#include "pipeline/programs/combine.hpp"

#include <cmath>
#include <cstdio>

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

/// The text that the caller of a refusal copies at once.
template <class... Values>
const char* sentence(const char* format, Values... values) {
  static thread_local char text[160];
  std::snprintf(text, sizeof text, format, values...);
  return text;
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

const char* refusal_of(const FixedFunctionUniforms& uniforms) {
  for (int number = 0; number < kTextureUnits; ++number) {
    const TextureUnit& unit = uniforms.units[static_cast<std::size_t>(number)];
    if (!unit.texture) continue;
    if (!is_known(unit.colour) || !is_known(unit.alpha))
      return sentence("unit %d: a function, source or operand is none of its enumeration", number);
    if (!is_scale(unit.colour.scale)) return sentence("unit %d: the colour's scale is %d, but can be 1, 2 or 4", number, unit.colour.scale);
    if (!is_scale(unit.alpha.scale)) return sentence("unit %d: the alpha's scale is %d, but can be 1, 2 or 4", number, unit.alpha.scale);
    if (unit.alpha.function >= CombineFunction::dot3_rgb) return sentence("unit %d: dot3 is no function of alpha", number);
    for (const float channel : {unit.constant.r, unit.constant.g, unit.constant.b, unit.constant.a})
      if (!in_unit(channel)) return sentence("unit %d: the constant has a channel of %g, outside [0, 1]", number, static_cast<double>(channel));
    if (const char* refusal = refusal_of(unit.sampler)) return sentence("unit %d: %s", number, refusal);
  }
  return nullptr;
}

}  // namespace tuberia
