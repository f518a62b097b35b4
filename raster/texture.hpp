#pragma once
// A texture with its mipmaps, ready to be sampled.

#include <cstdint>
#include <span>
#include <vector>

#include "base/aligned_vector.hpp"
#include "base/result.hpp"
#include "image/image.hpp"

namespace tuberia {

/// What the 8-bit codes of an image mean: intensities themselves, or sRGB codes of intensities
/// (photographs and painted textures). Alpha is linear in both.
enum class TextureEncoding : std::uint8_t { linear, srgb };

/// One level of the mipmap chain; texels row by row, row 0 at the top.
struct TextureLevel {
  int width = 0, height = 0;        // texels
  const std::uint32_t* texels = nullptr;  // red in the lowest byte, then green, blue, alpha
};

class Texture {
 public:
  static constexpr int kMaxSize = 16384;  // texels, each way

  /// Builds level i+1 from level i by means over its halves, in linear light, each level from the
  /// unrounded one before it and rounded once. An odd size is halved with fractional weights so
  /// that no texel is lost.                                            [A 1.1] [rules T6]
  static Result<Texture> create(const Image<Rgba8>& image, TextureEncoding encoding, bool with_mipmaps = true);

  TextureEncoding encoding() const noexcept { return encoding_; }
  int level_count() const noexcept { return static_cast<int>(levels_.size()); }
  const TextureLevel& level(int i) const noexcept { return levels_[static_cast<std::size_t>(i)]; }
  std::span<const TextureLevel> levels() const noexcept { return levels_; }

  /// A level as an image, for looking at.
  Image<Rgba8> level_image(int i) const;

 private:
  Texture() = default;
  TextureEncoding encoding_ = TextureEncoding::linear;
  std::vector<AlignedVector<std::uint32_t>> texels_;
  std::vector<TextureLevel> levels_;
};

}  // namespace tuberia
