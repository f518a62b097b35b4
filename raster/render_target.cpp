#include "raster/render_target.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "math/colour.hpp"

namespace tuberia {
namespace {

std::size_t bytes_per_pixel(ColourFormat format) { return format == ColourFormat::rgba32f ? 16 : 4; }

std::uint32_t codes_of(const Rgba32F& c, ColourFormat format) {
  const auto code = [&](float x) -> std::uint32_t {
    return format == ColourFormat::srgb8 ? srgb_code_from_linear(static_cast<double>(x)) : unorm8_from_linear(x);
  };
  return code(c.r) | code(c.g) << 8 | code(c.b) << 16 | static_cast<std::uint32_t>(unorm8_from_linear(c.a)) << 24;
}

Rgba8 rgba_of(std::uint32_t code) {
  return {static_cast<std::uint8_t>(code), static_cast<std::uint8_t>(code >> 8),
          static_cast<std::uint8_t>(code >> 16), static_cast<std::uint8_t>(code >> 24)};
}

std::uint32_t code_at(const std::byte* tile, int index) {
  std::uint32_t code;
  std::memcpy(&code, tile + static_cast<std::size_t>(index) * 4, 4);
  return code;
}

Rgba32F floats_at(const std::byte* tile, int index) {
  const float* block = reinterpret_cast<const float*>(tile) + index / kBlockPixels * (4 * kBlockPixels);
  const float* first = block + index % kBlockPixels;
  return {first[0], first[kBlockPixels], first[2 * kBlockPixels], first[3 * kBlockPixels]};
}

}  // namespace

float depth_of_code(std::int32_t code, DepthFormat format) noexcept {
  switch (format) {
    case DepthFormat::d16: return static_cast<float>(code / 65535.0);
    case DepthFormat::d24: return static_cast<float>(code / 16777215.0);
    case DepthFormat::d32f: break;
  }
  return std::bit_cast<float>(code);
}

std::int32_t code_of_depth(float depth, DepthFormat format) noexcept {
  const float clamped = depth > 0 ? std::min(depth, 1.0f) : 0.0f;
  switch (format) {
    case DepthFormat::d16: return static_cast<std::int32_t>(std::floor(static_cast<double>(clamped) * 65535.0 + 0.5));
    case DepthFormat::d24: return static_cast<std::int32_t>(std::floor(static_cast<double>(clamped) * 16777215.0 + 0.5));
    case DepthFormat::d32f: break;
  }
  return std::bit_cast<std::int32_t>(clamped);
}

Result<RenderTarget> RenderTarget::create(int width_pixels, int height_pixels, ColourFormat colour, DepthFormat depth) {
  if (width_pixels < 1 || height_pixels < 1 || width_pixels > kMaxSize || height_pixels > kMaxSize)
    return Error{"a render target of " + std::to_string(width_pixels) + "x" + std::to_string(height_pixels) +
                 " pixels is out of range: 1 to " + std::to_string(kMaxSize) + " each way"};
  RenderTarget target;
  target.width_ = width_pixels;
  target.height_ = height_pixels;
  target.tiles_per_row_ = (width_pixels + kTileSize - 1) / kTileSize;
  target.tile_rows_ = (height_pixels + kTileSize - 1) / kTileSize;
  target.colour_format_ = colour;
  target.depth_format_ = depth;
  const auto pixels = static_cast<std::size_t>(target.tile_count()) * kTilePixels;
  target.colour_.resize(pixels * bytes_per_pixel(colour));
  target.depth_.resize(pixels, code_of_depth(1.0f, depth));
  return target;
}

Tile RenderTarget::tile(int number) noexcept {
  return {.left = number % tiles_per_row_ * kTileSize,
          .top = number / tiles_per_row_ * kTileSize,
          .colour = const_cast<std::byte*>(tile_colour(number)),
          .depth = depth_.data() + static_cast<std::size_t>(number) * kTilePixels};
}

const std::byte* RenderTarget::tile_colour(int number) const noexcept {
  return colour_.data() + static_cast<std::size_t>(number) * kTilePixels * bytes_per_pixel(colour_format_);
}

void RenderTarget::clear_colour(const Rgba32F& colour, Workers& workers) {
  const std::uint32_t code = codes_of(colour, colour_format_);
  const float channels[4] = {colour.r, colour.g, colour.b, colour.a};
  parallel_for(workers, tile_count(), [&](std::int64_t number, int) {
    const Tile t = tile(static_cast<int>(number));
    if (colour_format_ != ColourFormat::rgba32f) {
      std::fill_n(static_cast<std::uint32_t*>(t.colour), kTilePixels, code);
      return;
    }
    float* plane = static_cast<float*>(t.colour);
    for (int i = 0; i < kTilePixels / kBlockPixels * 4; ++i, plane += kBlockPixels)
      std::fill_n(plane, kBlockPixels, channels[i % 4]);
  });
}

void RenderTarget::clear_depth(float depth, Workers& workers) {
  const std::int32_t code = code_of_depth(depth, depth_format_);
  parallel_for(workers, tile_count(), [&](std::int64_t number, int) {
    std::fill_n(tile(static_cast<int>(number)).depth, kTilePixels, code);
  });
}

template <class Pixel, class Read>
Image<Pixel> RenderTarget::linearized(Read&& read) const {
  Image<Pixel> image(width_, height_);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      image.at(x, y) = read(y / kTileSize * tiles_per_row_ + x / kTileSize, index_in_tile(x % kTileSize, y % kTileSize));
  return image;
}

Image<Rgba8> RenderTarget::colour_image() const {
  if (colour_format_ == ColourFormat::rgba32f)
    return linearized<Rgba8>([&](int number, int index) {
      return rgba_of(codes_of(floats_at(tile_colour(number), index), ColourFormat::rgba8));
    });
  return linearized<Rgba8>([&](int number, int index) { return rgba_of(code_at(tile_colour(number), index)); });
}

Image<Rgba32F> RenderTarget::linear_image() const {
  if (colour_format_ == ColourFormat::rgba32f)
    return linearized<Rgba32F>([&](int number, int index) { return floats_at(tile_colour(number), index); });
  const auto& decode = linear_from_srgb_codes();
  const bool srgb = colour_format_ == ColourFormat::srgb8;
  return linearized<Rgba32F>([&](int number, int index) {
    const Rgba8 c = rgba_of(code_at(tile_colour(number), index));
    const auto linear = [&](std::uint8_t code) { return srgb ? decode[code] : static_cast<float>(code) / 255.0f; };
    return Rgba32F{linear(c.r), linear(c.g), linear(c.b), static_cast<float>(c.a) / 255.0f};
  });
}

Image<float> RenderTarget::depth_image() const {
  return linearized<float>([&](int number, int index) {
    return depth_of_code(depth_[static_cast<std::size_t>(number) * kTilePixels + static_cast<std::size_t>(index)], depth_format_);
  });
}

Image<std::int32_t> RenderTarget::depth_codes() const {
  return linearized<std::int32_t>([&](int number, int index) {
    return depth_[static_cast<std::size_t>(number) * kTilePixels + static_cast<std::size_t>(index)];
  });
}

}  // namespace tuberia
