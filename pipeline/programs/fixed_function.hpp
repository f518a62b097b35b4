#pragma once
// The fixed-function fragment: up to four texture units, each combining its texel with what came
// before, as OpenGL 1.3 does.                                                           [GL13]

#include <array>
#include <memory>

#include "pipeline/fragment_program.hpp"
#include "raster/sampler.hpp"
#include "raster/texture.hpp"

namespace tuberia {

/// How a unit makes its colour (or alpha) of arguments a0, a1, a2; the result times `scale`, clamped
/// to [0, 1]. dot3 is 4 ((a0.r - 1/2)(a1.r - 1/2) + (a0.g - ...)... + ...) in all three channels;
/// dot3_rgba in alpha, too, where it takes the place of the alpha function.
enum class CombineFunction : std::uint8_t {
  replace,      // a0
  modulate,     // a0 a1
  add,          // a0 + a1
  add_signed,   // a0 + a1 - 1/2
  interpolate,  // a0 a2 + a1 (1 - a2)
  subtract,     // a0 - a1
  dot3_rgb, dot3_rgba,
};
enum class CombineSource : std::uint8_t { texture, constant, primary, previous };  // previous of unit 0: primary
enum class CombineOperand : std::uint8_t { colour, one_minus_colour, alpha, one_minus_alpha };

struct CombineArgument {
  CombineSource source = CombineSource::texture;
  CombineOperand operand = CombineOperand::colour;  // in the alpha half, colour means alpha
  bool operator==(const CombineArgument&) const = default;
};

struct Combine {
  CombineFunction function = CombineFunction::modulate;
  std::array<CombineArgument, 3> argument{{{CombineSource::texture}, {CombineSource::previous},
                                           {CombineSource::constant, CombineOperand::alpha}}};
  int scale = 1;  // 1, 2 or 4
  bool operator==(const Combine&) const = default;
};

struct TextureUnit {
  std::shared_ptr<const Texture> texture{};  // null: the unit is off and passes on what came before
  Sampler sampler{};
  Combine colour{}, alpha{};               // by default: texel times what came before
  Rgba32F constant{0, 0, 0, 0};            // linear, [0, 1]
};

/// Both halves of a unit's combination.
struct CombinePair {
  Combine colour, alpha;
  bool operator==(const CombinePair&) const = default;
};

// The environments of before there were combinations; T texel, P what came before, K the constant.
CombinePair replace_environment() noexcept;   // T;  alpha T
CombinePair modulate_environment() noexcept;  // P T;  alpha P T
CombinePair decal_environment() noexcept;     // T over P by T's alpha;  alpha P
CombinePair blend_environment() noexcept;     // K T + P (1 - T);  alpha P T
CombinePair add_environment() noexcept;       // P + T;  alpha P T

struct FixedFunctionUniforms {
  std::array<TextureUnit, kTextureUnits> units;
};

/// The primary colour is the interpolated vertex colour, clamped to [0, 1]; texture coordinates are
/// Attributes::unit0.. (see TexCoordUnit), divided by q; a cube map's direction is not divided. Depth
/// textures are compared with r / q, cube maps of depths with q. The mesh needs coordinates up to the
/// last unit that is on. Refused: a scale that is not 1, 2 or 4, a constant outside [0, 1], dot3 as the
/// alpha's function, a sampler that makes no sense.
FragmentProgram fixed_function(FixedFunctionUniforms uniforms);

}  // namespace tuberia
