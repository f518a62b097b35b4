// Textures as images again, for looking at.

#include "base/assertion.hpp"
#include "raster/texture.hpp"

namespace tuberia {
namespace {

/// An image of one slice; read(i) is the pixel of the level's texel i.
template <class Pixel, class Read>
Image<Pixel> slice_image(const TextureLevel& from, int slice, Read&& read) {
  TUBERIA_ASSERT(slice >= 0 && slice < from.slices, "slice outside the texture");
  Image<Pixel> image(from.width, from.height);
  const std::size_t first = static_cast<std::size_t>(slice) * image.pixels().size();
  for (std::size_t k = 0; k < image.pixels().size(); ++k) image.pixels()[k] = read(first + k);
  return image;
}

}  // namespace

Image<Rgba8> Texture::level_image(int i, int slice) const {
  TUBERIA_ASSERT(format() == TextureFormat::rgba8, "a texture of floats has no codes");
  return slice_image<Rgba8>(level(i), slice, [&](std::size_t k) -> Rgba8 {
    const std::uint32_t code = level(i).texels[k];
    return {static_cast<std::uint8_t>(code), static_cast<std::uint8_t>(code >> 8),
            static_cast<std::uint8_t>(code >> 16), static_cast<std::uint8_t>(code >> 24)};
  });
}

Image<Rgba32F> Texture::float_level_image(int i, int slice) const {
  TUBERIA_ASSERT(format() == TextureFormat::rgba32f, "only rgba32f textures have four floats a texel");
  return slice_image<Rgba32F>(level(i), slice, [&](std::size_t k) {
    const float* texel = level(i).floats + 4 * k;
    return Rgba32F{texel[0], texel[1], texel[2], texel[3]};
  });
}

Image<float> Texture::depth_level_image(int i, int slice) const {
  TUBERIA_ASSERT(format() == TextureFormat::depth32f, "only depth textures have depths");
  return slice_image<float>(level(i), slice, [&](std::size_t k) { return level(i).floats[k]; });
}

}  // namespace tuberia
