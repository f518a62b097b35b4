#include "raster/binning.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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
  tile_count_ = tiles_per_row * tile_rows;
  list_runs(triangles, clip, tiles_per_row, reach_pixels);

  // Of the tiles from the first to the last that is touched, count the entries, turn the counts into
  // beginnings, and deal the triangles out in order.
  std::uint32_t last = 0, entries = 0;
  first_tile_ = runs_.empty() ? 0 : runs_.front().tile;
  for (const Run& run : runs_) {
    first_tile_ = std::min(first_tile_, run.tile);
    last = std::max(last, run.tile);
    entries += run.count;
  }
  listed_tiles_ = runs_.empty() ? 0 : last - first_tile_ + 1;
  begin_.assign(listed_tiles_ + 2, 0);
  for (const Run& run : runs_) begin_[run.tile - first_tile_ + 2] += run.count;
  for (std::size_t i = 2; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  entries_.resize(entries);
  for (const Run& run : runs_) {
    // What dealing leaves here is the tile's end, which is the next one's beginning.
    std::uint32_t& next = begin_[run.tile - first_tile_ + 1];
    std::uint16_t* const to = entries_.data() + next;
    next += run.count;
    if (run.count == 1) *to = run.first;
    else std::iota(to, to + run.count, run.first);
  }
}

void TileLists::list_runs(std::span<const ScreenTriangle> triangles, const PixelRect& clip, int tiles_per_row, double reach_pixels) {
  const auto misses_tile = reach_pixels > 0 ? &misses<true> : &misses<false>;
  runs_.clear();
  // Most triangles touch the one tile that the one before touched, too.
  PixelRect current{0, 0, 0, 0};
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const ScreenTriangle& t = triangles[i];
    if (t.left >= current.left && t.top >= current.top && t.right < current.right && t.bottom < current.bottom) {
      ++runs_.back().count;
      continue;
    }
    const auto number = static_cast<std::uint16_t>(i);
    const int left = std::max<int>(t.left, clip.left) / kTileSize, right = std::min<int>(t.right, clip.right - 1) / kTileSize;
    const int top = std::max<int>(t.top, clip.top) / kTileSize, bottom = std::min<int>(t.bottom, clip.bottom - 1) / kTileSize;
    const bool large = right - left + bottom - top > 1;
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x)
        if (!large || !misses_tile(t, x, y, reach_pixels)) runs_.push_back({static_cast<std::uint32_t>(y * tiles_per_row + x), number, 1});
    const PixelRect tile{left * kTileSize, top * kTileSize, (left + 1) * kTileSize, (top + 1) * kTileSize};
    current = left == right && top == bottom ? intersection(tile, clip) : PixelRect{0, 0, 0, 0};
  }
}

}  // namespace tuberia
