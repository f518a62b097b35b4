#include "pipeline/pixel_contents.hpp"

#include <cstring>

#include "math/colour.hpp"

namespace tuberia {
namespace {

Rgba8 codes_at(const Tile& tile, int index) {
  Rgba8 codes;
  static_assert(sizeof codes == 4);
  std::memcpy(&codes, static_cast<const std::byte*>(tile.colour) + static_cast<std::size_t>(index) * 4, 4);
  return codes;
}

Rgba32F linear_of(const Rgba8& codes, ColourFormat format) {
  const auto& decode = linear_from_srgb_codes();
  const auto linear = [&](std::uint8_t code) { return format == ColourFormat::srgb8 ? decode[code] : static_cast<float>(code) / 255.0f; };
  return {linear(codes.r), linear(codes.g), linear(codes.b), static_cast<float>(codes.a) / 255.0f};
}

/// Floats lie block by block: 64 reds, 64 greens, 64 blues, 64 alphas.
Rgba32F floats_at(const Tile& tile, int index) {
  const float* first = static_cast<const float*>(tile.colour) + index / kBlockPixels * (4 * kBlockPixels) + index % kBlockPixels;
  return {first[0], first[kBlockPixels], first[2 * kBlockPixels], first[3 * kBlockPixels]};
}

}  // namespace

PixelContents pixel_contents(const Tile& tile, ColourFormat format, int x, int y) {
  PixelContents contents(static_cast<std::size_t>(tile.samples));
  for (int sample = 0; sample < tile.samples; ++sample) {
    SampleContents& s = contents[static_cast<std::size_t>(sample)];
    // The planes of a multisampled tile follow each other.
    const int index = sample * kTilePixels + index_in_tile(x - tile.left, y - tile.top);
    if (format == ColourFormat::rgba32f) {
      s.colour = floats_at(tile, index);
    } else {
      s.codes = codes_at(tile, index);
      s.colour = linear_of(*s.codes, format);
    }
    s.depth = tile.depth[index];
    if (tile.stencil != nullptr) s.stencil = tile.stencil[index];
  }
  return contents;
}

PixelContents pixel_contents(RenderTarget& target, int x, int y) {
  return pixel_contents(target.tile_at(x, y), target.colour_format(), x, y);
}

}  // namespace tuberia
