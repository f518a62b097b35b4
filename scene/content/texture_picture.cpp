#include "scene/content/texture_picture.hpp"

#include <random>

#include "image/file.hpp"
#include "image/read_image.hpp"
#include "math/colour.hpp"
#include "scene/content/develop.hpp"
#include "scene/procedural_images.hpp"

namespace tuberia {
namespace {

using Source = description::Texture::Source;

bool is_float_file(const description::Texture& texture) {
  const std::string extension = lower_case_extension(texture.file);
  return texture.source == Source::file && (extension == ".hdr" || extension == ".pfm");
}

Rgba32F opaque(const glm::vec3& colour) { return {colour.r, colour.g, colour.b, 1}; }

/// A number in [0, 1] from 24 random bits.
float random_unit(std::mt19937& random) { return static_cast<float>(random() >> 8) * 0x1p-24f; }

Image<Rgba32F> random_squares(const description::Texture& texture) {
  std::mt19937 random(texture.seed);
  Image<Rgba32F> colours(texture.squares, texture.squares);
  for (Rgba32F& colour : colours.pixels()) {
    const float r = random_unit(random), g = random_unit(random), b = random_unit(random);
    colour = opaque(texture.first + glm::vec3(r, g, b) * (texture.second - texture.first));
  }
  return colours;
}

/// Linear intensities in [0, 1]; the first colour is at the upper left.
Image<Rgba32F> made_picture(const description::Texture& texture) {
  Image<Rgba32F> image(texture.size, texture.size);
  const Image<Rgba32F> squares = texture.source == Source::random_squares ? random_squares(texture) : Image<Rgba32F>();
  const auto square_of = [&](int texel) { return static_cast<int>(std::int64_t{texel} * texture.squares / texture.size); };
  for (int y = 0; y < texture.size; ++y)
    for (int x = 0; x < texture.size; ++x) {
      const float across = (static_cast<float>(x) + 0.5f) / static_cast<float>(texture.size);
      image.at(x, y) = texture.source == Source::checker  ? opaque((square_of(x) + square_of(y)) % 2 == 0 ? texture.first : texture.second)
                       : texture.source == Source::gradient ? opaque(texture.first + across * (texture.second - texture.first))
                                                            : squares.at(square_of(x), square_of(y));
    }
  return image;
}

/// The pictures that scene/procedural_images.hpp makes, of codes; empty for others.
Image<Rgba8> procedural_image(const description::Texture& texture) {
  const int size = texture.size;
  switch (texture.source) {
    case Source::planet: return planet_image(2 * size, size, texture.seed);
    case Source::planet_heights: return planet_height_image(2 * size, size, texture.seed);
    case Source::bricks: return brick_image(size, size, texture.squares, texture.seed);
    case Source::brick_heights: return brick_height_image(size, size, texture.squares);
    case Source::stud_heights: return stud_height_image(size, size, texture.squares);
    default: return {};
  }
}

Result<TexturePicture> picture_in_file(const description::Texture& texture, const std::filesystem::path& path) {
  if (is_float_file(texture)) {
    auto light = read_float_image(path);
    return light ? Result<TexturePicture>(TexturePicture{.codes = {}, .light = *std::move(light)}) : light.error();
  }
  auto codes = read_image(path);
  return codes ? Result<TexturePicture>(TexturePicture{.codes = *std::move(codes), .is_srgb = texture.encoding == description::Texture::Encoding::srgb, .light = {}})
               : codes.error();
}

}  // namespace

Result<TexturePicture> texture_picture(const SceneDescription& scene, const description::Texture& texture) {
  if (texture.source == Source::checker || texture.source == Source::random_squares)
    return TexturePicture{.codes = srgb_codes_of(made_picture(texture)), .is_srgb = true, .light = {}};
  if (texture.source == Source::gradient) return TexturePicture{.codes = {}, .light = made_picture(texture)};
  if (texture.source != Source::file) {
    const bool is_colour = texture.source == Source::planet || texture.source == Source::bricks;
    return TexturePicture{.codes = procedural_image(texture), .is_srgb = is_colour, .light = {}};
  }
  auto picture = picture_in_file(texture, file_of(scene, texture.file));
  if (!picture) return Error{"texture '" + texture.name + "': " + picture.error().message};
  return picture;
}

Image<Rgba32F> light_of(const TexturePicture& picture) {
  if (picture.codes.empty()) return picture.light;
  const Image<Rgba8>& codes = picture.codes;
  Image<Rgba32F> image(codes.width(), codes.height());
  const auto linear = [&](std::uint8_t code) { return picture.is_srgb ? linear_from_srgb_codes()[code] : static_cast<float>(code) / 255; };
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    const Rgba8& from = codes.pixels()[i];
    image.pixels()[i] = {linear(from.r), linear(from.g), linear(from.b), static_cast<float>(from.a) / 255};
  }
  return image;
}

Result<Image<Rgba32F>> picture_of(const SceneDescription& scene, const description::Texture& texture) {
  if (texture.source == Source::checker || texture.source == Source::random_squares || texture.source == Source::gradient) return made_picture(texture);
  const auto picture = texture_picture(scene, texture);
  if (!picture) return picture.error();
  return light_of(*picture);
}

}  // namespace tuberia
