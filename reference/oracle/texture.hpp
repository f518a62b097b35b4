#pragma once
// Textures of the oracle, looked up one sample at a time.

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "reference/oracle/compare.hpp"
#include "reference/oracle/interval.hpp"

namespace tuberia::oracle {

using Colour = std::array<Interval, 4>;

enum class TextureKind { one_dimensional, two_dimensional, three_dimensional, cube };
enum class TexelFilter { nearest, bilinear };
enum class MipmapFilter { none, nearest, linear };
enum class Wrap { repeat, clamp, mirror, border };

enum class FilterWeights { floats, eight_bits };
enum class FootprintForm { usual, steps, ellipse };

struct Sampler {
  TexelFilter texels = TexelFilter::bilinear;
  MipmapFilter mipmaps = MipmapFilter::none;
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat, wrap_w = Wrap::repeat;
  glm::vec4 border{0};
  float lod_bias = 0, min_lod = 0, max_lod = 1000;
  float max_anisotropy = 1;
  std::optional<Compare> compare;  // of depth textures
  FilterWeights weights = FilterWeights::floats;
  FootprintForm footprint = FootprintForm::usual;
};

/// Linear texels, row by row, slice by slice (or face by face).
struct TextureLevel {
  int width = 0, height = 0, slices = 1;
  std::vector<Colour> texels;
  const Colour& at(int x, int y, int slice) const {
    return texels[(static_cast<std::size_t>(slice) * static_cast<std::size_t>(height) + static_cast<std::size_t>(y)) *
                      static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

struct Texture {
  TextureKind kind = TextureKind::two_dimensional;
  int width = 0, height = 1, slices = 1;
  bool is_srgb = false, has_mipmaps = false;
  bool is_depth = false;
  std::vector<std::array<std::uint8_t, 4>> texels;  // row 0 on top
  std::vector<float> depths;                        // in place of them
  std::vector<glm::vec4> floats;                    // or these: linear intensities of any size
  std::vector<TextureLevel> levels;                 // made by `complete`
};

/// Decodes the texels, and makes the smaller levels.
void complete(Texture&);

using Triple = std::array<Interval, 3>;

/// How far something changes to the next pixels of the quad, in x and in y.
struct Steps {
  Triple x{}, y{};
};

/// Where a texture is read: s, t, r (for cubes a direction), what depths are compared with, and how
/// far the coordinates change, as they are and (not of cubes) in texels of the largest level.
struct TexturePoint {
  Interval s, t, r, reference;
  Steps steps{}, texel_steps{};
};

/// The colour there, bounded.
Colour sample(const Texture&, const Sampler&, const TexturePoint&);

}  // namespace tuberia::oracle
