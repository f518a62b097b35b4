#pragma once
// What is drawn to: colours and depths, stored tile by tile; linear images are made once, at the end.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/aligned_vector.hpp"
#include "base/parallel_for.hpp"
#include "base/result.hpp"
#include "image/image.hpp"
#include "raster/tile.hpp"

namespace tuberia {

/// The depth that a code of a format stands for, in [0, 1].
float depth_of_code(std::int32_t code, DepthFormat format) noexcept;

/// The code nearest to a depth, clamped to [0, 1]: 0.5 is 8388608 in 24 bits.         [rules Z1]
std::int32_t code_of_depth(float depth, DepthFormat format) noexcept;

struct RenderTargetDescription {
  int width = 0, height = 0;  // pixels, 1..kMaxSize
  ColourFormat colour = ColourFormat::rgba8;
  DepthFormat depth = DepthFormat::d24;
  bool stencil = false;       // whether there is a stencil buffer, of 8 bits
  int samples = 1;            // a pixel: 1, 2, 4, 8 or 16
  bool operator==(const RenderTargetDescription&) const = default;
};

/// What to clear, and to what; the rest stays as it is.
struct ClearCommand {
  std::optional<Rgba32F> colour{};         // linear; encoded for the format, clamped to [0, 1] unless it stores floats
  std::optional<float> depth{};            // clamped to [0, 1]
  std::optional<std::uint8_t> stencil{};   // needs a stencil buffer
  std::optional<PixelRect> scissor{};      // pixels outside stay untouched
  ColourMask colour_mask{};
  std::uint8_t stencil_write_mask = 0xff;  // bits that are off stay
};

class RenderTarget {
 public:
  static constexpr int kMaxSize = 16384;  // pixels, each way: half the guard band

  /// Colours start as transparent black, depths as 1, stencil codes as 0. Error for a size outside
  /// 1..kMaxSize, or a number of samples that there is no pattern for.
  static Result<RenderTarget> create(const RenderTargetDescription& description);
  static Result<RenderTarget> create(int width_pixels, int height_pixels,
                                     ColourFormat colour = ColourFormat::rgba8,
                                     DepthFormat depth = DepthFormat::d24) {
    return create({.width = width_pixels, .height = height_pixels, .colour = colour, .depth = depth});
  }

  int width() const noexcept { return description_.width; }
  int height() const noexcept { return description_.height; }
  PixelRect bounds() const noexcept { return {0, 0, width(), height()}; }
  ColourFormat colour_format() const noexcept { return description_.colour; }
  DepthFormat depth_format() const noexcept { return description_.depth; }
  bool has_stencil() const noexcept { return description_.stencil; }
  int samples() const noexcept { return description_.samples; }
  const RenderTargetDescription& description() const noexcept { return description_; }

  /// All samples of the pixels in the scissor rectangle. Error, and nothing cleared, for a stencil
  /// code without a stencil buffer, and for a colour or depth that is not a number.
  Result<Nothing> clear(const ClearCommand& command, Workers& workers);
  /// Linear colour (encoded for the format; clamped to [0, 1] unless it stores floats).
  void clear_colour(const Rgba32F& colour, Workers& workers);
  /// Depth in [0, 1].
  void clear_depth(float depth, Workers& workers);

  int tiles_per_row() const noexcept { return tiles_per_row_; }
  int tile_rows() const noexcept { return tile_rows_; }
  int tile_count() const noexcept { return tiles_per_row_ * tile_rows_; }
  /// Tiles are numbered row by row.
  Tile tile(int number) noexcept;
  /// The tile that pixel (x, y) lies in.
  Tile tile_at(int x, int y) noexcept { return tile(y / kTileSize * tiles_per_row_ + x / kTileSize); }

  // Images of a multisampled target are those of its resolved pixels: see resolve.

  /// The codes as stored: linear ones of rgba8, sRGB ones of srgb8. A float target is rounded to
  /// linear codes.
  Image<Rgba8> colour_image() const;
  /// Linear intensities; alpha included.
  Image<Rgba32F> linear_image() const;
  /// Depths in [0, 1].
  Image<float> depth_image() const;
  /// Depths as the buffer stores them: unorm codes, or the bits of floats.
  Image<std::int32_t> depth_codes() const { return sample_depth_codes(0); }
  /// All 0 without a stencil buffer.
  Image<std::uint8_t> stencil_codes() const { return sample_stencil_codes(0); }

  /// One sample, 0..samples()-1, of every pixel.
  Image<Rgba8> sample_colour_image(int sample) const;
  Image<Rgba32F> sample_linear_image(int sample) const;
  Image<std::int32_t> sample_depth_codes(int sample) const;
  Image<std::uint8_t> sample_stencil_codes(int sample) const;

 private:
  friend Result<Nothing> resolve(const RenderTarget& from, RenderTarget& to, Workers& workers);
  RenderTarget() = default;
  const std::byte* tile_colour(int number, int sample) const noexcept;
  std::uint32_t code_at(int number, int index, int sample) const noexcept;
  Rgba32F floats_at(int number, int index, int sample) const noexcept;
  std::uint32_t resolved_code(int number, int index) const noexcept;
  Rgba32F resolved_floats(int number, int index) const noexcept;
  template <class Pixel, class Read>
  Image<Pixel> linearized(Read&& read) const;
  template <class Code, class Floats>
  Image<Rgba8> coded(Code&& code, Floats&& floats) const;
  template <class Code, class Floats>
  Image<Rgba32F> decoded(Code&& code, Floats&& floats) const;

  RenderTargetDescription description_;
  int tiles_per_row_ = 0, tile_rows_ = 0;
  AlignedVector<std::byte> colour_;
  AlignedVector<std::int32_t> depth_;
  AlignedVector<std::uint8_t> stencil_;
};

/// Makes the samples of each pixel one: the mean of the colours (8-bit codes: to the nearest,
/// halves up; of sRGB codes the mean of the light; halves and floats summed as floats), and sample
/// 0 of depth and stencil where `to` stores them alike. Error, and `to` untouched, unless both have
/// the same size and colour format and `to` has one sample.
Result<Nothing> resolve(const RenderTarget& from, RenderTarget& to, Workers& workers);

}  // namespace tuberia
