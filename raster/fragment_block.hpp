#pragma once
// 8x8 fragments of one triangle in memory: what the fragment stages hand on when each runs alone.

#include <cstdint>
#include <vector>

#include "raster/block.hpp"
#include "raster/instruction_set.hpp"
#include "raster/tile.hpp"

namespace tuberia {

/// Arrays are in the order of index_in_block. Only fragments whose bit is set in `live` count; what
/// nobody has written yet is indeterminate.
struct FragmentBlock {
  FragmentBlock() {}  // leaves the arrays alone: they are large, and written before they are read

  int left = 0, top = 0;               // pixel of the target, multiples of 8
  const ScreenTriangle* triangle = nullptr;
  std::uint64_t live = 0;              // bit i: a sample of fragment i is covered and has passed so far
  int samples = 1;
  std::uint64_t sample_live[kMaxSamples] = {};  // bit i: so has sample s of fragment i; `live` is their union
  alignas(64) float weight[2][kBlockPixels];   // barycentric, of vertices 1 and 2, screen space, at pixel centres
  alignas(64) float colour[4][kBlockPixels];   // red, green, blue, alpha; after the program
  alignas(64) float depth_value[kMaxSamples][kBlockPixels];   // interpolated, not yet clamped; after rasterization
  alignas(64) std::int32_t depth[kMaxSamples][kBlockPixels];  // codes; after the depth test
};

/// The fragment stages on memory, made of the same inline functions as the fused tile loop.
struct BlockKernels {
  /// Appends the blocks of one tile that the triangle covers, in memory order, by samples if the
  /// tile has several.
  void (*rasterize)(const ScreenTriangle&, const Tile&, const PixelRect& clip, std::vector<FragmentBlock>& out);
  /// Mixes the live colours with the fog's, by the fog coordinates (or shares) of the triangle's vertices.
  void (*fog)(FragmentBlock&, const ChunkView&, const OutputState&);
  /// Alpha to coverage, then the alpha test: clears the live bits that fail.
  void (*alpha_test)(FragmentBlock&, const OutputState&);
  /// Stencil and depth: computes depth codes, clears the live bits that fail, updates both buffers.
  void (*depth_test)(FragmentBlock&, const OutputState&, const Tile&);
  /// Blends the live colours into the tile.
  void (*blend)(const FragmentBlock&, const OutputState&, const Tile&);
};

const BlockKernels& block_kernels(InstructionSet, Precision) noexcept;

}  // namespace tuberia
