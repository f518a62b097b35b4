#include "scene/frame/frame_textures.hpp"

#include <array>
#include <random>

#include "image/file.hpp"
#include "image/read_image.hpp"
#include "math/colour.hpp"
#include "raster/level_colours.hpp"
#include "scene/frame/develop.hpp"
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

/// Colours are kept as codes, which are read faster than floats; what may be a height is not rounded to them.
Result<Texture> texture_of(const SceneDescription& scene, const description::Texture& texture) {
  if (texture.source == Source::checker || texture.source == Source::random_squares) return Texture::create(srgb_codes_of(made_picture(texture)), TextureEncoding::srgb);
  if (const Image<Rgba8> codes = procedural_image(texture); !codes.empty()) {
    const bool is_colour = texture.source == Source::planet || texture.source == Source::bricks;
    return Texture::create(codes, is_colour ? TextureEncoding::srgb : TextureEncoding::linear);
  }
  if (texture.source == Source::gradient) return Texture::create(made_picture(texture));
  const auto path = file_of(scene, texture.file);
  if (is_float_file(texture)) {
    const auto image = read_float_image(path);
    return image ? Texture::create(*image) : image.error();
  }
  const auto image = read_image(path);
  return image ? Texture::create(*image, texture.encoding == description::Texture::Encoding::srgb ? TextureEncoding::srgb : TextureEncoding::linear) : image.error();
}

Error error_in(const description::Texture& texture, const Error& error) { return {"texture '" + texture.name + "': " + error.message}; }

}  // namespace

Sampler sampler_of(const description::Texture& texture) noexcept {
  using Filter = description::Texture::Filter;
  constexpr std::array kWraps{Wrap::repeat, Wrap::clamp, Wrap::mirror};
  const Wrap wrap = kWraps[static_cast<std::size_t>(texture.wrap)];
  Sampler sampler{.wrap_u = wrap, .wrap_v = wrap, .wrap_w = wrap, .max_anisotropy = static_cast<float>(texture.anisotropy)};
  if (texture.filter == Filter::nearest || texture.filter == Filter::mipmap_nearest) sampler.texels = TexelFilter::nearest;
  if (texture.filter == Filter::nearest || texture.filter == Filter::bilinear) sampler.mipmaps = MipmapFilter::none;
  if (texture.filter == Filter::mipmap_nearest) sampler.mipmaps = MipmapFilter::nearest;
  return sampler;
}

Result<FrameTexture> frame_texture(const SceneDescription& scene, const description::Texture& texture) {
  auto made = texture_of(scene, texture);
  if (made && texture.level_colours) made = level_coloured_texture(made->level(0).width, made->level(0).height);
  if (!made) return error_in(texture, made.error());
  FrameTexture ready{.texture = std::make_shared<const Texture>(*std::move(made)), .sampler = sampler_of(texture)};
  if (texture.level_rule == description::Texture::LevelRule::distance) ready.access.level_rule = TextureAccess::LevelRule::distance;
  ready.access.texel_distance = static_cast<float>(texture.texel_distance);
  return ready;
}

Result<Image<Rgba32F>> picture_of(const SceneDescription& scene, const description::Texture& texture) {
  if (texture.source == Source::checker || texture.source == Source::random_squares || texture.source == Source::gradient) return made_picture(texture);
  const auto made = texture_of(scene, texture);
  if (!made) return error_in(texture, made.error());
  if (made->format() == TextureFormat::rgba32f) return made->float_level_image(0);
  const Image<Rgba8> codes = made->level_image(0);
  Image<Rgba32F> image(codes.width(), codes.height());
  const bool is_srgb = made->encoding() == TextureEncoding::srgb;
  const auto linear = [&](std::uint8_t code) { return is_srgb ? linear_from_srgb_codes()[code] : static_cast<float>(code) / 255; };
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    const Rgba8& from = codes.pixels()[i];
    image.pixels()[i] = {linear(from.r), linear(from.g), linear(from.b), static_cast<float>(from.a) / 255};
  }
  return image;
}

}  // namespace tuberia
