#include "raster/texture_target.hpp"

namespace tuberia {

Result<Nothing> copy_to_texture(const RenderTarget& target, Texture& texture, int level, int slice) {
  const ColourFormat format = target.colour_format();
  if (format == ColourFormat::rgba32f || format == ColourFormat::rgba16f) {
    if (texture.format() != TextureFormat::rgba32f) return Error{"a target of floats can only be copied to a texture of floats (rgba32f)"};
    return texture.replace(level, slice, target.linear_image());
  }
  if (texture.format() != TextureFormat::rgba8) return Error{"a target of 8-bit codes can only be copied to a texture of such codes (rgba8)"};
  const auto encoding = format == ColourFormat::srgb8 ? TextureEncoding::srgb : TextureEncoding::linear;
  if (texture.encoding() != encoding) return Error{"the target's codes and the texture's are not both linear or both sRGB"};
  return texture.replace(level, slice, target.colour_image());
}

Result<Nothing> copy_depth_to_texture(const RenderTarget& target, Texture& texture, int level, int face) {
  if (texture.format() != TextureFormat::depth32f) return Error{"depths can only be copied to a depth texture (depth32f)"};
  return texture.replace(level, face, target.depth_image());
}

}  // namespace tuberia
