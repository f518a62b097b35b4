#pragma once
// Blending: how a fragment's colour and the pixel's make the new pixel.

#include <cstdint>

#include "image/image.hpp"

namespace tuberia {

/// What a render target stores. rgba8: linear codes; srgb8: sRGB codes of linear colours (blending
/// decodes and encodes); rgba16f and rgba32f: linear floats, unbounded.
enum class ColourFormat : std::uint8_t { rgba8, srgb8, rgba32f, rgba16f };

/// The three everyday modes, which are fused into the tile loops, and the general one.
enum class BlendMode : std::uint8_t {
  replace,      // C
  source_over,  // C * A + pixel * (1 - A); alpha: A + pixel * (1 - A)
  additive,     // C + pixel, alpha likewise
  function,     // by BlendState::colour and BlendState::alpha
};

/// What a colour is multiplied with before the equation; source: the fragment, destination: the pixel.
enum class BlendFactor : std::uint8_t {
  zero, one,
  source_colour, one_minus_source_colour, destination_colour, one_minus_destination_colour,
  source_alpha, one_minus_source_alpha, destination_alpha, one_minus_destination_alpha,
  constant_colour, one_minus_constant_colour, constant_alpha, one_minus_constant_alpha,
  source_alpha_saturate,  // min(source alpha, 1 - destination alpha); 1 for alpha
};

/// S and D are the products with their factors; min and max use no factors.
enum class BlendEquation : std::uint8_t { add, subtract, reverse_subtract, min, max };  // S+D, S-D, D-S

struct BlendFunction {
  BlendFactor source = BlendFactor::one, destination = BlendFactor::zero;
  BlendEquation equation = BlendEquation::add;
  bool operator==(const BlendFunction&) const = default;
};

/// Bit by bit on the 8-bit codes; S: the fragment's, D: the pixel's. They take the place of blending.
enum class LogicOperation : std::uint8_t {
  off, clear, and_, and_reverse, copy, and_inverted, noop, xor_, or_, nor, equivalent, invert,
  or_reverse, copy_inverted, or_inverted, nand, set,
};

/// Which channels are stored.
struct ColourMask {
  bool red = true, green = true, blue = true, alpha = true;
  bool operator==(const ColourMask&) const = default;
  constexpr bool all() const noexcept { return red && green && blue && alpha; }
};

struct BlendState {
  BlendMode mode = BlendMode::replace;
  bool write = true;  // false: colours stay as they are (a depth-only pass)
  BlendFunction colour{}, alpha{};                      // of BlendMode::function
  Rgba32F constant{0, 0, 0, 0};                        // of the constant factors
  LogicOperation logic = LogicOperation::off;          // only for rgba8
  ColourMask mask{};
  bool operator==(const BlendState&) const = default;
};

}  // namespace tuberia
