#pragma once
// What a pixel of a target holds, for those who look at one pixel and not at a picture.

#include <cstdint>
#include <optional>
#include <vector>

#include "image/image.hpp"
#include "raster/render_target.hpp"

namespace tuberia {

/// One sample of a pixel.
struct SampleContents {
  Rgba32F colour{0, 0, 0, 0};             // linear intensities
  std::optional<Rgba8> codes{};           // as stored, in the 8-bit formats
  std::int32_t depth = 0;                 // code; the bits of a float with d32f
  std::optional<std::uint8_t> stencil{};  // where the target has a stencil buffer
  bool operator==(const SampleContents&) const = default;
};

/// One entry a sample; a single one unless the target is multisampled.
using PixelContents = std::vector<SampleContents>;

/// The tile must hold the pixel (x, y) of the target.
PixelContents pixel_contents(const Tile& tile, ColourFormat format, int x, int y);

/// The pixel must lie within the target.
PixelContents pixel_contents(RenderTarget& target, int x, int y);

}  // namespace tuberia
