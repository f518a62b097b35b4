#pragma once
// 8x8 fragments of one triangle in memory: what the fragment stages hand on when each runs alone.

#include <cstdint>
#include <vector>

#include "raster/block.hpp"
#include "raster/instruction_set.hpp"
#include "raster/tile.hpp"

namespace tuberia {

/// Arrays are in the order of index_in_block. Only fragments whose bit is set in `live` count.
struct FragmentBlock {
  int left = 0, top = 0;               // pixel of the target, multiples of 8
  const ScreenTriangle* triangle = nullptr;
  std::uint64_t live = 0;              // bit i: fragment i is covered and has passed so far
  alignas(64) float weight[2][kBlockPixels] = {};  // barycentric, of vertices 1 and 2, screen space
  alignas(64) std::int32_t depth[kBlockPixels] = {};  // codes, after the depth test
  alignas(64) float colour[4][kBlockPixels] = {};  // red, green, blue, alpha; after the program
};

/// The fragment stages on memory, made of the same inline functions as the fused tile loop.
struct BlockKernels {
  /// Appends the blocks of one tile that the triangle covers, in memory order.
  void (*rasterize)(const ScreenTriangle&, const Tile&, const PixelRect& clip, std::vector<FragmentBlock>& out);
  /// Computes depth codes, clears the live bits that fail, and stores what passes.
  void (*depth_test)(FragmentBlock&, const OutputState&, const Tile&);
  /// Blends the live colours into the tile.
  void (*blend)(const FragmentBlock&, const OutputState&, const Tile&);
};

const BlockKernels& block_kernels(InstructionSet, Precision) noexcept;

}  // namespace tuberia
