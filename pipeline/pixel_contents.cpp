#include "pipeline/pixel_contents.hpp"

#include <cstring>

#include "math/colour.hpp"
#include "raster/half_float.hpp"

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

/// Floats and halves lie block by block: 64 reds, 64 greens, 64 blues, 64 alphas.
template <class Number, class ToFloat>
Rgba32F floats_at(const void* colour, int index, ToFloat&& to_float) {
  const Number* first = static_cast<const Number*>(colour) + index / kBlockPixels * (4 * kBlockPixels) + index % kBlockPixels;
  return {to_float(first[0]), to_float(first[kBlockPixels]), to_float(first[2 * kBlockPixels]), to_float(first[3 * kBlockPixels])};
}

SampleContents contents_at(const Tile& plane, ColourFormat format, int index) {
  SampleContents contents;
  if (format == ColourFormat::rgba32f) {
    contents.colour = floats_at<float>(plane.colour, index, [](float x) { return x; });
  } else if (format == ColourFormat::rgba16f) {
    contents.colour = floats_at<std::uint16_t>(plane.colour, index, float_from_half);
  } else {
    contents.codes = codes_at(plane, index);
    contents.colour = linear_of(*contents.codes, format);
  }
  contents.depth = plane.depth[index];
  if (plane.stencil != nullptr) contents.stencil = plane.stencil[index];
  return contents;
}

}  // namespace

PixelContents pixel_contents(const Tile& tile, ColourFormat format, int x, int y) {
  PixelContents contents;
  for (int sample = 0; sample < tile.samples; ++sample)
    contents.push_back(contents_at(plane_of_sample(tile, format, sample), format, index_in_tile(x - tile.left, y - tile.top)));
  return contents;
}

PixelContents pixel_contents(RenderTarget& target, int x, int y) {
  return pixel_contents(target.tile_at(x, y), target.colour_format(), x, y);
}

}  // namespace tuberia
