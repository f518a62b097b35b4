#pragma once
// What is drawn to: colours and depths, stored tile by tile; linear images are made once, at the end.

#include <cstdint>
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

class RenderTarget {
 public:
  static constexpr int kMaxSize = 16384;  // pixels, each way: half the guard band

  /// Colours start as transparent black, depths as 1. Error for a size outside 1..kMaxSize.
  static Result<RenderTarget> create(int width_pixels, int height_pixels,
                                     ColourFormat colour = ColourFormat::rgba8,
                                     DepthFormat depth = DepthFormat::d24);

  int width() const noexcept { return width_; }
  int height() const noexcept { return height_; }
  PixelRect bounds() const noexcept { return {0, 0, width_, height_}; }
  ColourFormat colour_format() const noexcept { return colour_format_; }
  DepthFormat depth_format() const noexcept { return depth_format_; }

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

  /// The codes as stored: linear ones of rgba8, sRGB ones of srgb8. A float target is rounded to
  /// linear codes.
  Image<Rgba8> colour_image() const;
  /// Linear intensities; alpha included.
  Image<Rgba32F> linear_image() const;
  /// Depths in [0, 1].
  Image<float> depth_image() const;
  /// Depths as the buffer stores them: unorm codes, or the bits of floats.
  Image<std::int32_t> depth_codes() const;

 private:
  RenderTarget() = default;
  const std::byte* tile_colour(int number) const noexcept;
  template <class Pixel, class Read>
  Image<Pixel> linearized(Read&& read) const;

  int width_ = 0, height_ = 0, tiles_per_row_ = 0, tile_rows_ = 0;
  ColourFormat colour_format_ = ColourFormat::rgba8;
  DepthFormat depth_format_ = DepthFormat::d24;
  AlignedVector<std::byte> colour_;
  AlignedVector<std::int32_t> depth_;
};

}  // namespace tuberia
