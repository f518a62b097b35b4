#pragma once
// Which triangles of a chunk touch which tile.

#include <cstdint>
#include <span>
#include <vector>

#include "raster/block.hpp"
#include "raster/screen_triangle.hpp"

namespace tuberia {

/// For every tile of a target the triangles that may touch it, in the order they were submitted.
class TileLists {
 public:
  /// Bins triangles (65535 at most) by their bounds within `clip`; large ones also by their edges.
  /// reach_pixels: how far beside a pixel's centre coverage is tested: 0, or 1/2 with several samples.
  void build(std::span<const ScreenTriangle> triangles, const PixelRect& clip, int tiles_per_row, int tile_rows,
             double reach_pixels = 0);

  int tile_count() const noexcept { return tile_count_; }
  /// No tile before the first and from the end on has any; both 0 when none has.
  int first_tile() const noexcept { return static_cast<int>(first_tile_); }
  int end_tile() const noexcept { return static_cast<int>(first_tile_ + listed_tiles_); }
  std::span<const std::uint16_t> of_tile(int tile) const noexcept {
    const std::size_t i = static_cast<std::uint32_t>(tile) - first_tile_;  // wraps around below it
    if (i >= listed_tiles_) return {};
    return {entries_.data() + begin_[i], begin_[i + 1] - begin_[i]};
  }

 private:
  void list_runs(std::span<const ScreenTriangle> triangles, const PixelRect& clip, int tiles_per_row, double reach_pixels);

  // Only the tiles from the first to the last that is touched are kept, so that a chunk costs no more
  // on a large target.
  int tile_count_ = 0;
  std::uint32_t first_tile_ = 0, listed_tiles_ = 0;
  std::vector<std::uint32_t> begin_;   // of each listed tile's entries; more at the end
  std::vector<std::uint16_t> entries_;

  /// Triangles one after the other that touch a tile: first, first + 1, ...
  struct Run {
    std::uint32_t tile;
    std::uint16_t first, count;
  };
  std::vector<Run> runs_;  // in submission order
};

}  // namespace tuberia
