#include "raster/texture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/colour.hpp"

namespace tuberia {
namespace {

/// A level before its rounding to codes.
using LinearImage = Image<Rgba32F>;

Rgba32F linear_of(Rgba8 code, TextureEncoding encoding) {
  const float alpha = static_cast<float>(code.a) / 255.0f;
  if (encoding == TextureEncoding::srgb) {
    const auto& decode = linear_from_srgb_codes();
    return {decode[code.r], decode[code.g], decode[code.b], alpha};
  }
  return {static_cast<float>(code.r) / 255.0f, static_cast<float>(code.g) / 255.0f,
          static_cast<float>(code.b) / 255.0f, alpha};
}

std::uint32_t code_of(const Rgba32F& linear, TextureEncoding encoding) {
  const auto code = [&](float x) -> std::uint32_t {
    return encoding == TextureEncoding::srgb ? srgb_code_from_linear(static_cast<double>(x)) : unorm8_from_linear(x);
  };
  return code(linear.r) | code(linear.g) << 8 | code(linear.b) << 16 |
         static_cast<std::uint32_t>(unorm8_from_linear(linear.a)) << 24;
}

std::uint32_t code_of(Rgba8 c) {
  return static_cast<std::uint32_t>(c.r) | static_cast<std::uint32_t>(c.g) << 8 |
         static_cast<std::uint32_t>(c.b) << 16 | static_cast<std::uint32_t>(c.a) << 24;
}

/// Which texels of a row of `size` make texel i of the halved row, and with which weights: two
/// halves of an even row; of an odd row 2m+1 three, sharing the outer ones with the neighbours.
struct Taps {
  int first = 0, count = 1;
  std::array<float, 3> weight{1, 0, 0};
};

Taps taps_of(int size, int i) {
  if (size == 1) return {};
  if (size % 2 == 0) return {.first = 2 * i, .count = 2, .weight = {0.5f, 0.5f, 0}};
  const int half = size / 2;
  const float unit = 1.0f / static_cast<float>(size);
  return {.first = 2 * i, .count = 3,
          .weight = {static_cast<float>(half - i) * unit, static_cast<float>(half) * unit,
                     static_cast<float>(i + 1) * unit}};
}

LinearImage halve(const LinearImage& from) {
  LinearImage to(std::max(1, from.width() / 2), std::max(1, from.height() / 2));
  for (int y = 0; y < to.height(); ++y) {
    const Taps rows = taps_of(from.height(), y);
    for (int x = 0; x < to.width(); ++x) {
      const Taps columns = taps_of(from.width(), x);
      Rgba32F sum{0, 0, 0, 0};
      for (int j = 0; j < rows.count; ++j)
        for (int i = 0; i < columns.count; ++i) {
          const float weight = rows.weight[static_cast<std::size_t>(j)] * columns.weight[static_cast<std::size_t>(i)];
          const Rgba32F& texel = from.at(columns.first + i, rows.first + j);
          sum.r += weight * texel.r;
          sum.g += weight * texel.g;
          sum.b += weight * texel.b;
          sum.a += weight * texel.a;
        }
      to.at(x, y) = sum;
    }
  }
  return to;
}

}  // namespace

Result<Texture> Texture::create(const Image<Rgba8>& image, TextureEncoding encoding, bool with_mipmaps) {
  if (image.width() < 1 || image.height() < 1 || image.width() > kMaxSize || image.height() > kMaxSize)
    return Error{"a texture of " + std::to_string(image.width()) + " x " + std::to_string(image.height()) +
                 " texels is out of range: 1 to " + std::to_string(kMaxSize) + " each way"};

  Texture texture;
  texture.encoding_ = encoding;
  const auto add_level = [&](int width, int height, AlignedVector<std::uint32_t> codes) {
    texture.texels_.push_back(std::move(codes));
    texture.levels_.push_back({width, height, texture.texels_.back().data()});
  };

  AlignedVector<std::uint32_t> base(image.pixels().size());
  std::transform(image.pixels().begin(), image.pixels().end(), base.begin(), [](Rgba8 c) { return code_of(c); });
  add_level(image.width(), image.height(), std::move(base));
  if (!with_mipmaps || (image.width() == 1 && image.height() == 1)) return texture;

  LinearImage unrounded(image.width(), image.height());
  std::transform(image.pixels().begin(), image.pixels().end(), unrounded.pixels().begin(),
                 [&](Rgba8 c) { return linear_of(c, encoding); });
  while (unrounded.width() > 1 || unrounded.height() > 1) {
    unrounded = halve(unrounded);
    AlignedVector<std::uint32_t> codes(unrounded.pixels().size());
    std::transform(unrounded.pixels().begin(), unrounded.pixels().end(), codes.begin(),
                   [&](const Rgba32F& c) { return code_of(c, encoding); });
    add_level(unrounded.width(), unrounded.height(), std::move(codes));
  }
  return texture;
}

Image<Rgba8> Texture::level_image(int i) const {
  const TextureLevel& from = level(i);
  Image<Rgba8> image(from.width, from.height);
  for (std::size_t k = 0; k < image.pixels().size(); ++k) {
    const std::uint32_t code = from.texels[k];
    image.pixels()[k] = {static_cast<std::uint8_t>(code), static_cast<std::uint8_t>(code >> 8),
                         static_cast<std::uint8_t>(code >> 16), static_cast<std::uint8_t>(code >> 24)};
  }
  return image;
}

}  // namespace tuberia
