#pragma once
// How a texture is read.

#include <cstdint>

#include "image/image.hpp"

namespace tuberia {

/// Inside one mipmap level: the texel under the point, or the weighted mean of the nearest four.
enum class TexelFilter : std::uint8_t { nearest, bilinear };

/// Between levels: always the base level, the nearest level, or the weighted mean of two
/// (bilinear with linear is called trilinear filtering).
enum class MipmapFilter : std::uint8_t { none, nearest, linear };

/// What lies outside [0, 1]: the texture again, its edge texels, its mirror image, or a colour.
enum class Wrap : std::uint8_t { repeat, clamp, mirror, border };

struct Sampler {
  TexelFilter texels = TexelFilter::bilinear;
  MipmapFilter mipmaps = MipmapFilter::linear;
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  Rgba32F border{0, 0, 0, 0};
  float lod_bias = 0;  // added to the level of detail
  bool operator==(const Sampler&) const = default;
};

}  // namespace tuberia
