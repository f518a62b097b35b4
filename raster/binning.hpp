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

  int tile_count() const noexcept { return begin_.empty() ? 0 : static_cast<int>(begin_.size()) - 1; }
  std::span<const std::uint16_t> of_tile(int tile) const noexcept {
    const auto i = static_cast<std::size_t>(tile);
    return {entries_.data() + begin_[i], begin_[i + 1] - begin_[i]};
  }

 private:
  std::vector<std::uint32_t> begin_;   // of each tile's entries; one more at the end
  std::vector<std::uint16_t> entries_;

  struct Touch {
    std::uint32_t tile;
    std::uint16_t triangle;
  };
  std::vector<Touch> touched_;  // in submission order
};

}  // namespace tuberia
