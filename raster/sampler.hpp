#pragma once
// How a texture is read.

#include <cstdint>
#include <optional>

#include "image/image.hpp"
#include "raster/depth_state.hpp"

namespace tuberia {

/// Inside one mipmap level: the texel under the point, or the weighted mean of the nearest ones (two
/// in one dimension, four in two, eight in three).
enum class TexelFilter : std::uint8_t { nearest, bilinear };

/// Between levels: always the base level, the nearest level, or the weighted mean of two
/// (bilinear with linear is called trilinear filtering).
enum class MipmapFilter : std::uint8_t { none, nearest, linear };

/// What lies outside [0, 1]: the texture again, its edge texels, its mirror image, or a colour.
enum class Wrap : std::uint8_t { repeat, clamp, mirror, border };

/// The weights of texels within a level: as floats, or rounded to 1/256 as in most hardware, halves up.
enum class FilterWeights : std::uint8_t { floats, eight_bits };

/// What the level of detail takes for the size of a pixel on the texture: the longer of its steps to
/// the right and down (and, filtered anisotropically, the shorter), or the axes of the ellipse that
/// both span. usual: steps where the filter is isotropic, the ellipse where it is not.       [rules T3]
enum class Footprint : std::uint8_t { usual, steps, ellipse };

struct Sampler {
  TexelFilter texels = TexelFilter::bilinear;
  MipmapFilter mipmaps = MipmapFilter::linear;
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat, wrap_w = Wrap::repeat;  // cube maps wrap nothing
  Rgba32F border{0, 0, 0, 0};  // a depth texture's border is its red
  float lod_bias = 0;          // added to the level of detail
  float min_lod = 0, max_lod = 1000;  // which then is clamped to these, and at last to the levels there are
  // How many times longer than wide the footprint of a pixel may be before the mipmaps blur it
  // lengthwise, too: 1..16. As many samples, rounded up, are taken along it.
  float max_anisotropy = 1;
  // For depth textures: the mean of the truth values (1 or 0) of "reference <compare> texel" over the
  // texels that the filter reads. Other textures do not look at it.
  std::optional<Compare> compare{};
  FilterWeights weights = FilterWeights::floats;
  Footprint footprint = Footprint::usual;
  bool operator==(const Sampler&) const = default;
};

/// Why a sampler makes no sense: an anisotropy outside 1..16, bounds in the wrong order (infinite
/// ones are none), a bias or border that is not finite; null when it does. The text lasts until the
/// next one on this thread. Sampling with a sampler that is refused is safe all the same.
const char* refusal_of(const Sampler& sampler) noexcept;

}  // namespace tuberia
