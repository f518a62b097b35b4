#pragma once
// What a draw remembers of a tile, so that what nobody would see need not be drawn: which pixels it
// has written, and how far away the farthest pixel of each block is. See docs/performance.md.

#include <cstdint>
#include <limits>
#include <vector>

#include "raster/tile.hpp"

namespace tuberia {

/// The order in which a tile meets the triangles of a draw. The picture is always that of the order
/// of submission; where it does not matter otherwise, the nearest surfaces had better come first.
enum class DrawOrder : std::uint8_t { as_submitted, last_first };

/// The number of the i-th of so many things that are met in an order.
constexpr std::int64_t in_draw_order(std::int64_t i, std::int64_t count, DrawOrder order) noexcept {
  return order == DrawOrder::last_first ? count - 1 - i : i;
}

/// Whether nearness alone decides which fragment a pixel keeps, and that it is stored for the next
/// one: the comparisons by size, with writing.
constexpr bool keeps_nearest(const DepthState& depth) noexcept {
  return depth.write && (depth.test == Compare::less || depth.test == Compare::less_equal || depth.test == Compare::greater ||
                         depth.test == Compare::greater_equal);
}

/// Whether a draw may meet its triangles last first. Fragments that replace a pixel do not depend on
/// each other but through the stored depth, and there the nearest one wins in any order. (Ties, and
/// depths that nobody writes, are decided by TileVisibility::written.)
constexpr bool is_order_free(const OutputState& s) noexcept {
  const bool depth_stays = !s.depth.write || s.depth.test == Compare::equal || s.depth.test == Compare::always;
  return is_everyday(s) && (s.blend.mode == BlendMode::replace || !s.blend.write) && (keeps_nearest(s.depth) || depth_stays);
}

inline constexpr int kBlocksPerTile = kTilePixels / kBlockPixels;

struct TileVisibility {
  static constexpr std::int32_t kNotLookedFor = std::numeric_limits<std::int32_t>::min();   // less than any key
  static constexpr std::int32_t kNeverLookedAt = std::numeric_limits<std::int32_t>::max();  // greater than any

  std::uint64_t draw = 0;                        // the draw that the rest belongs to
  // Of each block at least the largest key of a stored depth: see HiddenSurfaces. Keys only get smaller
  // while a draw lasts, so an old one is never wrong, only a reason to look again, and so are:
  std::int32_t farthest[kBlocksPerTile];
  std::uint8_t doubts[kBlocksPerTile];           // registers written and questions answered no since the last look
  bool is_summarized = false;                    // the two below are up to date
  std::int32_t farthest_of_all = 0, nearest_of_all = 0;  // the largest and the smallest of `farthest`
  std::int32_t nearest_pixel = kNotLookedFor;    // the smallest key of any pixel, in draws that write no depth
  std::uint64_t written[kBlocksPerTile];         // last_first: bit i of word b: pixel i of block b

  /// Nothing is known, nothing written.
  void begin(std::uint64_t new_draw) noexcept {
    draw = new_draw;
    is_summarized = false;
    nearest_pixel = kNotLookedFor;
    for (int block = 0; block < kBlocksPerTile; ++block) {
      farthest[block] = kNeverLookedAt;
      doubts[block] = 1;
      written[block] = 0;
    }
  }
};

/// That of all tiles of a target, for one draw after the other.
class TargetVisibility {
 public:
  /// Forgets what the last draw left; tiles that the new one does not touch cost nothing.
  void begin_draw(int tile_count) {
    ++draw_;
    if (tiles_.size() < static_cast<std::size_t>(tile_count)) tiles_.resize(static_cast<std::size_t>(tile_count));
  }
  TileVisibility& of_tile(std::int64_t number) noexcept {
    TileVisibility& tile = tiles_[static_cast<std::size_t>(number)];
    if (tile.draw != draw_) tile.begin(draw_);
    return tile;
  }

 private:
  std::uint64_t draw_ = 0;
  std::vector<TileVisibility> tiles_;
};

}  // namespace tuberia
