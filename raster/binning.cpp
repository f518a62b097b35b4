#include "raster/binning.hpp"

#include <algorithm>
#include <cmath>

namespace tuberia {
namespace {

/// Whether the tile lies wholly outside one edge. Exact: whole numbers below 2^53.
template <bool kBesideCentres>
bool misses(const ScreenTriangle& t, int tile_x, int tile_y, double reach_pixels) {
  constexpr double kSpan = kTileSize - 1;
  for (int i = 0; i < 3; ++i) {
    const double per_x = t.per_x[i], per_y = t.per_y[i];
    double largest = t.constant[i] + per_x * (tile_x * kTileSize) + per_y * (tile_y * kTileSize) +
                     std::max(0.0, per_x) * kSpan + std::max(0.0, per_y) * kSpan;
    // The remainder, too, may carry a sample over by less than one.
    if constexpr (kBesideCentres) largest += reach_pixels * (std::abs(per_x) + std::abs(per_y)) + 1;
    if (largest < 0) return true;
  }
  return false;
}

}  // namespace

void TileLists::build(std::span<const ScreenTriangle> triangles, const PixelRect& clip, int tiles_per_row, int tile_rows,
                      double reach_pixels) {
  const auto tiles = static_cast<std::size_t>(tiles_per_row) * static_cast<std::size_t>(tile_rows);
  begin_.assign(tiles + 1, 0);
  touched_.clear();
  const auto misses_tile = reach_pixels > 0 ? &misses<true> : &misses<false>;

  // List the pairs and count them by tile, ...
  for (std::size_t number = 0; number < triangles.size(); ++number) {
    const ScreenTriangle& t = triangles[number];
    const int left = std::max<int>(t.left, clip.left) / kTileSize, right = std::min<int>(t.right, clip.right - 1) / kTileSize;
    const int top = std::max<int>(t.top, clip.top) / kTileSize, bottom = std::min<int>(t.bottom, clip.bottom - 1) / kTileSize;
    const bool large = right - left + bottom - top > 1;
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) {
        if (large && misses_tile(t, x, y, reach_pixels)) continue;
        const auto tile = static_cast<std::uint32_t>(y * tiles_per_row + x);
        touched_.push_back({tile, static_cast<std::uint16_t>(number)});
        ++begin_[tile + 1];
      }
  }

  // ... turn the counts into beginnings, and deal the triangles out in order.
  for (std::size_t tile = 0; tile < tiles; ++tile) begin_[tile + 1] += begin_[tile];
  entries_.resize(touched_.size());
  for (const Touch& touch : touched_) entries_[begin_[touch.tile]++] = touch.triangle;
  // Dealing moved every beginning to its end, which is the next one's beginning.
  for (std::size_t tile = tiles; tile > 0; --tile) begin_[tile] = begin_[tile - 1];
  begin_[0] = 0;
}

}  // namespace tuberia
