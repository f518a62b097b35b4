#include "raster/texture.hpp"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>

#include "math/colour.hpp"
#include "raster/mipmaps.hpp"

namespace tuberia {
namespace {

Rgba32F linear_of(std::uint32_t code, TextureEncoding encoding) {
  const auto channel = [&](int shift) { return code >> shift & 0xffu; };
  const float alpha = static_cast<float>(channel(24)) / 255.0f;
  if (encoding == TextureEncoding::srgb) {
    const auto& decode = linear_from_srgb_codes();
    return {decode[channel(0)], decode[channel(8)], decode[channel(16)], alpha};
  }
  return {static_cast<float>(channel(0)) / 255.0f, static_cast<float>(channel(8)) / 255.0f,
          static_cast<float>(channel(16)) / 255.0f, alpha};
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

std::size_t floats_per_texel(TextureFormat format) { return format == TextureFormat::rgba32f ? 4 : 1; }

std::size_t texel_count(const TextureLevel& level) {
  return static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height) * static_cast<std::size_t>(level.slices);
}

std::string size_of(const TextureShape& s) {
  std::string size = std::to_string(s.width) + " x " + std::to_string(s.height);
  if (s.kind == TextureKind::three_dimensional) size += " x " + std::to_string(s.depth);
  return size;
}

/// Why there is no texture of this shape.
std::optional<Error> refusal_of(const TextureShape& s) {
  if (s.kind > TextureKind::cube || s.format > TextureFormat::depth32f || s.encoding > TextureEncoding::srgb)
    return Error{"there are no textures of kind " + std::to_string(static_cast<int>(s.kind)) + ", format " +
                 std::to_string(static_cast<int>(s.format)) + " and encoding " + std::to_string(static_cast<int>(s.encoding))};
  const bool is_box = s.kind == TextureKind::three_dimensional, is_cube = s.kind == TextureKind::cube;
  const int most = is_box ? Texture::kMaxVolumeSize : is_cube ? Texture::kMaxCubeSize : Texture::kMaxSize;
  const auto within = [&](int size) { return size >= 1 && size <= most; };
  if (!within(s.width) || !within(s.height) || !within(s.depth))
    return Error{"a texture of " + size_of(s) + " texels is out of range: 1 to " + std::to_string(most) + " each way"};
  if (s.kind == TextureKind::one_dimensional && s.height != 1) return Error{"a one-dimensional texture of " + size_of(s) + " texels has too many rows"};
  if (!is_box && s.depth != 1) return Error{"a texture with " + std::to_string(s.depth) + " slices has to be three-dimensional"};
  if (is_cube && s.width != s.height) return Error{"the faces of a cube map are squares, not " + size_of(s) + " texels"};
  if (is_box && s.format == TextureFormat::depth32f) return Error{"there are no three-dimensional depth textures"};
  return {};
}

TextureLevel halved_level(const TextureLevel& level, TextureKind kind) {
  const bool is_box = kind == TextureKind::three_dimensional;
  return {.width = std::max(1, level.width / 2), .height = std::max(1, level.height / 2),
          .slices = is_box ? std::max(1, level.slices / 2) : level.slices};
}

bool is_last(const TextureLevel& level, TextureKind kind) {
  return level.width == 1 && level.height == 1 && (kind == TextureKind::cube || level.slices == 1);
}

LinearLevel unrounded(const TextureLevel& level, const TextureShape& shape) {
  LinearLevel result{level.width, level.height, level.slices, std::vector<Rgba32F>(texel_count(level))};
  for (std::size_t i = 0; i < result.texels.size(); ++i) {
    switch (shape.format) {
      case TextureFormat::rgba8: result.texels[i] = linear_of(level.texels[i], shape.encoding); break;
      case TextureFormat::rgba32f: {
        const float* floats = level.floats + 4 * i;
        result.texels[i] = {floats[0], floats[1], floats[2], floats[3]};
        break;
      }
      case TextureFormat::depth32f: result.texels[i] = {level.floats[i], 0, 0, 0}; break;
    }
  }
  return result;
}

void store_texel(std::uint32_t& to, Rgba8 from) { to = code_of(from); }
void store_texel(float* to, const Rgba32F& from) { std::memcpy(to, &from, sizeof from); }
void store_texel(float* to, float from) { *to = from; }

}  // namespace

Result<Texture> Texture::create_empty(const TextureShape& shape) {
  if (auto refusal = refusal_of(shape)) return *std::move(refusal);
  Texture texture;
  texture.shape_ = shape;
  if (shape.format != TextureFormat::rgba8) texture.shape_.encoding = TextureEncoding::linear;
  TextureLevel level{.width = shape.width, .height = shape.height, .slices = shape.kind == TextureKind::cube ? 6 : shape.depth};
  while (true) {
    if (shape.format == TextureFormat::rgba8) texture.texels_.emplace_back(texel_count(level), 0u);
    else texture.floats_.emplace_back(texel_count(level) * floats_per_texel(shape.format), 0.0f);
    texture.levels_.push_back(level);
    if (!shape.with_mipmaps || is_last(level, shape.kind)) break;
    level = halved_level(level, shape.kind);
  }
  texture.point_levels_at_texels();
  return texture;
}

void Texture::point_levels_at_texels() noexcept {
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    levels_[i].texels = texels_.empty() ? nullptr : texels_[i].data();
    levels_[i].floats = floats_.empty() ? nullptr : floats_[i].data();
  }
}

void Texture::note_opacity(std::size_t level) noexcept {
  const auto is_opaque = [](std::uint32_t code) { return code >> 24 == 255; };
  levels_[level].is_opaque = is_rectangle_of_codes() && std::all_of(texels_[level].begin(), texels_[level].end(), is_opaque);
}

Texture::Texture(const Texture& other) : shape_(other.shape_), texels_(other.texels_), floats_(other.floats_), levels_(other.levels_) {
  point_levels_at_texels();
}

Texture& Texture::operator=(const Texture& other) { return *this = Texture(other); }

template <class Pixel>
Result<Nothing> Texture::replace_slice(int level, int slice, const Image<Pixel>& image, TextureFormat format) {
  if (format != shape_.format) return Error{"the texture has texels of another format than the image"};
  if (level < 0 || level >= level_count())
    return Error{"level " + std::to_string(level) + " is not there: the texture has " + std::to_string(level_count()) + " levels"};
  const auto number = static_cast<std::size_t>(level);
  const TextureLevel& to = levels_[number];
  if (slice < 0 || slice >= to.slices)
    return Error{"slice or face " + std::to_string(slice) + " is not there: level " + std::to_string(level) + " has " + std::to_string(to.slices)};
  if (image.width() != to.width || image.height() != to.height)
    return Error{"an image of " + std::to_string(image.width()) + " x " + std::to_string(image.height()) + " cannot replace level " +
                 std::to_string(level) + ", which has " + std::to_string(to.width) + " x " + std::to_string(to.height) + " texels"};
  const std::size_t first = static_cast<std::size_t>(slice) * image.pixels().size();
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    if constexpr (std::is_same_v<Pixel, Rgba8>) store_texel(texels_[number][first + i], image.pixels()[i]);
    else store_texel(floats_[number].data() + (first + i) * floats_per_texel(format), image.pixels()[i]);
  }
  note_opacity(number);
  return Nothing{};
}

Result<Nothing> Texture::replace(int level, int slice, const Image<Rgba8>& codes) { return replace_slice(level, slice, codes, TextureFormat::rgba8); }
Result<Nothing> Texture::replace(int level, int slice, const Image<Rgba32F>& intensities) {
  return replace_slice(level, slice, intensities, TextureFormat::rgba32f);
}
Result<Nothing> Texture::replace(int level, int slice, const Image<float>& depths) { return replace_slice(level, slice, depths, TextureFormat::depth32f); }

void Texture::generate_mipmaps() {
  if (level_count() == 1) return;
  LinearLevel level = unrounded(levels_.front(), shape_);
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    level = halved(level, shape_.kind == TextureKind::three_dimensional);
    for (std::size_t k = 0; k < level.texels.size(); ++k) {
      switch (shape_.format) {
        case TextureFormat::rgba8: texels_[i][k] = code_of(level.texels[k], shape_.encoding); break;
        case TextureFormat::rgba32f: store_texel(floats_[i].data() + 4 * k, level.texels[k]); break;
        case TextureFormat::depth32f: store_texel(floats_[i].data() + k, level.texels[k].r); break;
      }
    }
    note_opacity(i);
  }
}

template <class Pixel>
Result<Texture> Texture::create_from(const TextureShape& shape, std::span<const Image<Pixel>> slices) {
  auto texture = create_empty(shape);
  if (!texture) return texture;
  for (std::size_t i = 0; i < slices.size(); ++i)
    if (auto replaced = texture->replace(0, static_cast<int>(i), slices[i]); !replaced)
      return Error{"slice or face " + std::to_string(i) + ": " + replaced.error().message};
  texture->generate_mipmaps();
  return texture;
}

Result<Texture> Texture::create(const Image<Rgba8>& image, TextureEncoding encoding, bool with_mipmaps) {
  const TextureShape shape{.encoding = encoding, .width = image.width(), .height = image.height(), .with_mipmaps = with_mipmaps};
  return create_from<Rgba8>(shape, std::span(&image, 1));
}

Result<Texture> Texture::create(const Image<Rgba32F>& image, bool with_mipmaps) {
  const TextureShape shape{.format = TextureFormat::rgba32f, .width = image.width(), .height = image.height(), .with_mipmaps = with_mipmaps};
  return create_from<Rgba32F>(shape, std::span(&image, 1));
}

Result<Texture> Texture::create_depth(const Image<float>& depths) {
  const TextureShape shape{.format = TextureFormat::depth32f, .width = depths.width(), .height = depths.height(), .with_mipmaps = false};
  return create_from<float>(shape, std::span(&depths, 1));
}

Result<Texture> Texture::create_1d(std::span<const Rgba8> texels, TextureEncoding encoding, bool with_mipmaps) {
  if (texels.empty() || texels.size() > kMaxSize)
    return Error{"a texture of " + std::to_string(texels.size()) + " texels is out of range: 1 to " + std::to_string(kMaxSize)};
  Image<Rgba8> row(static_cast<int>(texels.size()), 1);
  std::copy(texels.begin(), texels.end(), row.pixels().begin());
  const TextureShape shape{.kind = TextureKind::one_dimensional, .encoding = encoding, .width = row.width(), .with_mipmaps = with_mipmaps};
  return create_from<Rgba8>(shape, std::span<const Image<Rgba8>>(&row, 1));
}

Result<Texture> Texture::create_3d(std::span<const Image<Rgba8>> slices, TextureEncoding encoding, bool with_mipmaps) {
  if (slices.empty() || slices.size() > kMaxVolumeSize)
    return Error{"a texture of " + std::to_string(slices.size()) + " slices is out of range: 1 to " + std::to_string(kMaxVolumeSize)};
  return create_from<Rgba8>({.kind = TextureKind::three_dimensional, .encoding = encoding, .width = slices.front().width(),
                             .height = slices.front().height(), .depth = static_cast<int>(slices.size()), .with_mipmaps = with_mipmaps}, slices);
}

Result<Texture> Texture::create_cube(std::span<const Image<Rgba8>, 6> faces, TextureEncoding encoding, bool with_mipmaps) {
  return create_from<Rgba8>({.kind = TextureKind::cube, .encoding = encoding, .width = faces[0].width(), .height = faces[0].height(),
                             .with_mipmaps = with_mipmaps}, faces);
}

Result<Texture> Texture::create_cube(std::span<const Image<Rgba32F>, 6> faces, bool with_mipmaps) {
  return create_from<Rgba32F>({.kind = TextureKind::cube, .format = TextureFormat::rgba32f, .width = faces[0].width(), .height = faces[0].height(),
                               .with_mipmaps = with_mipmaps}, faces);
}

}  // namespace tuberia
