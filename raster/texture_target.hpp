#pragma once
// Drawing into textures: what a render target holds becomes a level of a texture.

#include "base/result.hpp"
#include "raster/render_target.hpp"
#include "raster/texture.hpp"

namespace tuberia {

/// Replaces a slice (or face) of a level by the target's colours, resolved if it has several samples.
/// rgba8 and srgb8 targets fill textures of codes with the same encoding, code by code; targets of
/// floats fill rgba32f. Error for any other pair, or if sizes differ. Other levels stay as they are:
/// Texture::generate_mipmaps makes them follow.
Result<Nothing> copy_to_texture(const RenderTarget& target, Texture& texture, int level = 0, int slice = 0);

/// The same with the target's depths, for shadow maps: the texture must be depth32f. Codes of 16 and
/// 24 bits become the float nearest to what they stand for.
Result<Nothing> copy_depth_to_texture(const RenderTarget& target, Texture& texture, int level = 0, int face = 0);

}  // namespace tuberia
