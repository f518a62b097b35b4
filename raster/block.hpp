#pragma once
// How pixels lie in memory: a tile is 8x8 blocks, a block 4x4 quads, a quad 2x2 pixels.
//
// Within a quad the order is (0,0) (1,0) (0,1) (1,1), and quads follow each other in the same
// zigzag, first within 4x4 pixels, then within the block (Morton order). Neighbours in memory are
// therefore compact groups, whatever the width of the machine's vectors: 4 lanes are 2x2 pixels,
// 8 are 4x2, 16 are 4x4, each one contiguous load; compact, because a small triangle then touches
// few of them; and screen-space derivatives are differences inside groups of four lanes.

#include <cstdint>

namespace tuberia {

inline constexpr int kBlockSize = 8;                              // pixels, each way
inline constexpr int kBlockPixels = kBlockSize * kBlockSize;      // 64: one bit each in a mask
#ifndef TUBERIA_TILE_SIZE
#define TUBERIA_TILE_SIZE 64  // only script/verify_determinism builds with others
#endif
inline constexpr int kTileSize = TUBERIA_TILE_SIZE;               // pixels, each way
inline constexpr int kBlocksPerTileRow = kTileSize / kBlockSize;
inline constexpr int kTilePixels = kTileSize * kTileSize;
static_assert(kTileSize % kBlockSize == 0 && kTileSize <= 64);

/// Index of pixel (x, y), 0..7 each, in a block: the bits of x and y by turns.
constexpr int index_in_block(int x, int y) noexcept {
  return (x & 1) | (y & 1) << 1 | (x & 2) << 1 | (y & 2) << 2 | (x & 4) << 2 | (y & 4) << 3;
}

/// Column and row in its block of the pixel at an index.
constexpr int block_x(int index) noexcept { return (index & 1) | (index >> 1 & 2) | (index >> 2 & 4); }
constexpr int block_y(int index) noexcept { return block_x(index >> 1); }

/// Index of pixel (x, y) of a tile, 0..kTileSize-1 each.
constexpr int index_in_tile(int x, int y) noexcept {
  return ((y / kBlockSize) * kBlocksPerTileRow + x / kBlockSize) * kBlockPixels +
         index_in_block(x % kBlockSize, y % kBlockSize);
}

/// Column and row in its tile of the pixel at an index.
constexpr int column_in_tile(int index) noexcept { return index / kBlockPixels % kBlocksPerTileRow * kBlockSize + block_x(index % kBlockPixels); }
constexpr int row_in_tile(int index) noexcept { return index / kBlockPixels / kBlocksPerTileRow * kBlockSize + block_y(index % kBlockPixels); }

/// A rectangle of whole pixels: left and top belong to it, right and bottom do not.
struct PixelRect {
  int left = 0, top = 0, right = 0, bottom = 0;
  bool operator==(const PixelRect&) const = default;
  constexpr bool empty() const noexcept { return left >= right || top >= bottom; }
};

constexpr PixelRect intersection(const PixelRect& a, const PixelRect& b) noexcept {
  return {a.left > b.left ? a.left : b.left, a.top > b.top ? a.top : b.top,
          a.right < b.right ? a.right : b.right, a.bottom < b.bottom ? a.bottom : b.bottom};
}

}  // namespace tuberia
