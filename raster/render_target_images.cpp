// What a render target shows: its tiles as images, and many samples as one.

#include <algorithm>
#include <cstring>
#include <string>

#include "math/colour.hpp"
#include "raster/half_float.hpp"
#include "raster/render_target.hpp"

namespace tuberia {
namespace {

Rgba8 rgba_of(std::uint32_t code) {
  return {static_cast<std::uint8_t>(code), static_cast<std::uint8_t>(code >> 8),
          static_cast<std::uint8_t>(code >> 16), static_cast<std::uint8_t>(code >> 24)};
}

Rgba8 unorm8_of(const Rgba32F& c) {
  return {unorm8_from_linear(c.r), unorm8_from_linear(c.g), unorm8_from_linear(c.b), unorm8_from_linear(c.a)};
}

bool stores_floats(ColourFormat format) { return format == ColourFormat::rgba32f || format == ColourFormat::rgba16f; }

/// The four channels of a pixel whose planes lie kBlockPixels apart.
template <class Channel>
Channel* planes_at(std::byte* tile, int index) {
  return reinterpret_cast<Channel*>(tile) + index / kBlockPixels * (4 * kBlockPixels) + index % kBlockPixels;
}
template <class Channel>
const Channel* planes_at(const std::byte* tile, int index) {
  return reinterpret_cast<const Channel*>(tile) + index / kBlockPixels * (4 * kBlockPixels) + index % kBlockPixels;
}

/// A pixel of floats, or the nearest halves.
void store_floats(std::byte* tile, int index, ColourFormat format, const Rgba32F& c) {
  const float channels[4] = {c.r, c.g, c.b, c.a};
  for (int i = 0; i < 4; ++i) {
    if (format == ColourFormat::rgba32f) planes_at<float>(tile, index)[i * kBlockPixels] = channels[i];
    else planes_at<std::uint16_t>(tile, index)[i * kBlockPixels] = half_from_float(channels[i]);
  }
}

std::string size_of(const RenderTarget& target) { return std::to_string(target.width()) + "x" + std::to_string(target.height()); }

const char* name_of(ColourFormat format) {
  switch (format) {
    case ColourFormat::rgba8: return "rgba8";
    case ColourFormat::srgb8: return "srgb8";
    case ColourFormat::rgba32f: return "rgba32f";
    case ColourFormat::rgba16f: break;
  }
  return "rgba16f";
}

}  // namespace

std::uint32_t RenderTarget::code_at(int number, int index, int sample) const noexcept {
  std::uint32_t code;
  std::memcpy(&code, tile_colour(number, sample) + static_cast<std::size_t>(index) * 4, 4);
  return code;
}

Rgba32F RenderTarget::floats_at(int number, int index, int sample) const noexcept {
  const std::byte* tile = tile_colour(number, sample);
  if (colour_format() == ColourFormat::rgba32f) {
    const float* p = planes_at<float>(tile, index);
    return {p[0], p[kBlockPixels], p[2 * kBlockPixels], p[3 * kBlockPixels]};
  }
  const std::uint16_t* p = planes_at<std::uint16_t>(tile, index);
  return {float_from_half(p[0]), float_from_half(p[kBlockPixels]), float_from_half(p[2 * kBlockPixels]), float_from_half(p[3 * kBlockPixels])};
}

std::uint32_t RenderTarget::resolved_code(int number, int index) const noexcept {
  if (samples() == 1) return code_at(number, index, 0);
  std::uint32_t sum[4] = {};
  double light[3] = {};
  for (int s = 0; s < samples(); ++s) {
    const std::uint32_t code = code_at(number, index, s);
    for (int c = 0; c < 4; ++c) sum[c] += code >> 8 * c & 0xffu;
    for (int c = 0; c < 3; ++c) light[c] += static_cast<double>(linear_from_srgb_codes()[code >> 8 * c & 0xffu]);
  }
  const auto n = static_cast<std::uint32_t>(samples());
  std::uint32_t mean = 0;
  for (int c = 0; c < 4; ++c) {
    const bool by_light = colour_format() == ColourFormat::srgb8 && c < 3;
    mean |= (by_light ? srgb_code_from_linear(light[c % 3] / samples()) : (2 * sum[c] + n) / (2 * n)) << 8 * c;
  }
  return mean;
}

Rgba32F RenderTarget::resolved_floats(int number, int index) const noexcept {
  Rgba32F sum = floats_at(number, index, 0);
  if (samples() == 1) return sum;
  for (int s = 1; s < samples(); ++s) {
    const Rgba32F one = floats_at(number, index, s);
    sum = {sum.r + one.r, sum.g + one.g, sum.b + one.b, sum.a + one.a};
  }
  const float share = 1.0f / static_cast<float>(samples());
  const auto stored = [&](float x) { return colour_format() == ColourFormat::rgba32f ? x * share : float_from_half(half_from_float(x * share)); };
  return {stored(sum.r), stored(sum.g), stored(sum.b), stored(sum.a)};
}

template <class Pixel, class Read>
Image<Pixel> RenderTarget::linearized(Read&& read) const {
  Image<Pixel> image(width(), height());
  for (int y = 0; y < height(); ++y)
    for (int x = 0; x < width(); ++x)
      image.at(x, y) = read(y / kTileSize * tiles_per_row_ + x / kTileSize, index_in_tile(x % kTileSize, y % kTileSize));
  return image;
}

template <class Code, class Floats>
Image<Rgba8> RenderTarget::coded(Code&& code, Floats&& floats) const {
  if (stores_floats(colour_format())) return linearized<Rgba8>([&](int number, int index) { return unorm8_of(floats(number, index)); });
  return linearized<Rgba8>([&](int number, int index) { return rgba_of(code(number, index)); });
}

template <class Code, class Floats>
Image<Rgba32F> RenderTarget::decoded(Code&& code, Floats&& floats) const {
  if (stores_floats(colour_format())) return linearized<Rgba32F>(floats);
  const auto& decode = linear_from_srgb_codes();
  const bool srgb = colour_format() == ColourFormat::srgb8;
  return linearized<Rgba32F>([&](int number, int index) {
    const Rgba8 c = rgba_of(code(number, index));
    const auto linear = [&](std::uint8_t one) { return srgb ? decode[one] : static_cast<float>(one) / 255.0f; };
    return Rgba32F{linear(c.r), linear(c.g), linear(c.b), static_cast<float>(c.a) / 255.0f};
  });
}

Image<Rgba8> RenderTarget::colour_image() const {
  return coded([this](int number, int index) { return resolved_code(number, index); },
               [this](int number, int index) { return resolved_floats(number, index); });
}

Image<Rgba32F> RenderTarget::linear_image() const {
  return decoded([this](int number, int index) { return resolved_code(number, index); },
                 [this](int number, int index) { return resolved_floats(number, index); });
}

Image<Rgba8> RenderTarget::sample_colour_image(int sample) const {
  return coded([=, this](int number, int index) { return code_at(number, index, sample); },
               [=, this](int number, int index) { return floats_at(number, index, sample); });
}

Image<Rgba32F> RenderTarget::sample_linear_image(int sample) const {
  return decoded([=, this](int number, int index) { return code_at(number, index, sample); },
                 [=, this](int number, int index) { return floats_at(number, index, sample); });
}

Image<std::int32_t> RenderTarget::sample_depth_codes(int sample) const {
  return linearized<std::int32_t>([&](int number, int index) {
    return depth_[(static_cast<std::size_t>(number * samples() + sample)) * kTilePixels + static_cast<std::size_t>(index)];
  });
}

Image<float> RenderTarget::depth_image() const {
  const Image<std::int32_t> codes = depth_codes();
  Image<float> depths(width(), height());
  std::transform(codes.pixels().begin(), codes.pixels().end(), depths.pixels().begin(),
                 [this](std::int32_t code) { return depth_of_code(code, depth_format()); });
  return depths;
}

Image<std::uint8_t> RenderTarget::sample_stencil_codes(int sample) const {
  if (!has_stencil()) return Image<std::uint8_t>(width(), height(), 0);
  return linearized<std::uint8_t>([&](int number, int index) {
    return stencil_[(static_cast<std::size_t>(number * samples() + sample)) * kTilePixels + static_cast<std::size_t>(index)];
  });
}

Result<Nothing> resolve(const RenderTarget& from, RenderTarget& to, Workers& workers) {
  if (from.width() != to.width() || from.height() != to.height())
    return Error{"resolve: the targets have different sizes, " + size_of(from) + " and " + size_of(to) + " pixels"};
  if (from.colour_format() != to.colour_format())
    return Error{std::string("resolve: the targets have different colour formats, ") + name_of(from.colour_format()) + " and " + name_of(to.colour_format())};
  if (to.samples() != 1) return Error{"resolve: the target that is written to has " + std::to_string(to.samples()) + " samples a pixel; it must have 1"};
  parallel_for(workers, to.tile_count(), [&](std::int64_t item, int) {
    const auto number = static_cast<int>(item);
    const Tile tile = to.tile(number);
    const std::size_t first = static_cast<std::size_t>(number) * kTilePixels * static_cast<std::size_t>(from.samples());
    for (int i = 0; i < kTilePixels; ++i) {
      if (stores_floats(to.colour_format())) store_floats(static_cast<std::byte*>(tile.colour), i, to.colour_format(), from.resolved_floats(number, i));
      else static_cast<std::uint32_t*>(tile.colour)[i] = from.resolved_code(number, i);
    }
    if (from.depth_format() == to.depth_format()) std::copy_n(from.depth_.data() + first, kTilePixels, tile.depth);
    if (from.has_stencil() && to.has_stencil()) std::copy_n(from.stencil_.data() + first, kTilePixels, tile.stencil);
  });
  return Nothing{};
}

}  // namespace tuberia
