#pragma once
// What the fragment stages work on: a tile of the render target and the state that governs it.

#include <cstdint>

#include "raster/blend_state.hpp"
#include "raster/block.hpp"
#include "raster/depth_state.hpp"
#include "raster/screen_triangle.hpp"

namespace tuberia {

/// One tile's pixels; those beyond the target's right and lower edges exist but are never shown.
struct Tile {
  int left = 0, top = 0;           // pixel of the target, a multiple of kTileSize
  void* colour = nullptr;          // kTilePixels codes, or per block 64 reds, 64 greens, 64 blues, 64 alphas
  std::int32_t* depth = nullptr;   // kTilePixels codes; floats as their bits: both order as integers
};

/// How fragments become pixels: everything after the fragment program.
struct OutputState {
  DepthState depth;
  BlendState blend;
  DepthFormat depth_format = DepthFormat::d24;
  ColourFormat colour_format = ColourFormat::rgba8;
  float min_depth = 0, max_depth = 1;  // depths are clamped to these before they are stored
  PixelRect clip;                      // scissor and viewport and target: nothing outside is touched
};

/// The triangles of one chunk, ready to be drawn, with the attributes of their vertices.
struct ChunkView {
  const ScreenTriangle* triangles = nullptr;
  const float* attributes = nullptr;  // stride floats a vertex slot
  int stride = 0;
};

}  // namespace tuberia
