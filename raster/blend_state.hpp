#pragma once
// Blending: how a fragment's colour and the pixel's make the new pixel.

#include <cstdint>

namespace tuberia {

/// What a render target stores. rgba8: linear codes; srgb8: sRGB codes of linear colours (blending
/// decodes and encodes); rgba32f: linear floats, unbounded.
enum class ColourFormat : std::uint8_t { rgba8, srgb8, rgba32f };

enum class BlendMode : std::uint8_t {
  replace,      // C
  source_over,  // C * A + pixel * (1 - A); alpha: A + pixel * (1 - A)
  additive,     // C + pixel, alpha likewise
};

struct BlendState {
  BlendMode mode = BlendMode::replace;
  bool write = true;  // false: colours stay as they are (a depth-only pass)
  bool operator==(const BlendState&) const = default;
};

}  // namespace tuberia
