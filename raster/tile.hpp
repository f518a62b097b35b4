#pragma once
// What the fragment stages work on: a tile of the render target and the state that governs it.

#include <cstddef>
#include <cstdint>

#include "raster/blend_state.hpp"
#include "raster/block.hpp"
#include "raster/depth_state.hpp"
#include "raster/fragment_state.hpp"
#include "raster/sample_positions.hpp"
#include "raster/screen_shape.hpp"
#include "raster/screen_triangle.hpp"
#include "raster/stencil_state.hpp"

namespace tuberia {

/// One tile's pixels; those beyond the target's right and lower edges exist but are never shown.
struct Tile {
  int left = 0, top = 0;           // pixel of the target, a multiple of kTileSize
  void* colour = nullptr;          // kTilePixels codes; of floats and halves, per block 64 reds, 64 greens, 64 blues, 64 alphas
  std::int32_t* depth = nullptr;   // kTilePixels codes; floats as their bits: both order as integers
  std::uint8_t* stencil = nullptr; // kTilePixels codes; null when the target has none
  int samples = 1;                 // of a multisampled tile: so many planes of the above, one after the other
};

constexpr int bytes_per_pixel(ColourFormat format) noexcept {
  return format == ColourFormat::rgba32f ? 16 : format == ColourFormat::rgba16f ? 8 : 4;
}

/// The planes of one sample of a tile.
inline Tile plane_of_sample(const Tile& tile, ColourFormat format, int sample) noexcept {
  Tile plane = tile;
  plane.colour = static_cast<std::byte*>(tile.colour) + static_cast<std::ptrdiff_t>(sample) * kTilePixels * bytes_per_pixel(format);
  plane.depth = tile.depth + static_cast<std::ptrdiff_t>(sample) * kTilePixels;
  if (tile.stencil != nullptr) plane.stencil = tile.stencil + static_cast<std::ptrdiff_t>(sample) * kTilePixels;
  plane.samples = 1;
  return plane;
}

/// How fragments become pixels: everything after the fragment program.
struct OutputState {
  DepthState depth{};
  BlendState blend{};
  DepthFormat depth_format = DepthFormat::d24;
  ColourFormat colour_format = ColourFormat::rgba8;
  float min_depth = 0, max_depth = 1;  // depths are clamped to these before they are stored
  PixelRect clip{};                      // scissor and viewport and target: nothing outside is touched

  // What the fused tile loops leave to the staged ones; see is_everyday.
  StencilState stencil{};
  AlphaTest alpha_test{};
  FogState fog{};
  SampleState multisampling{};
  StipplePattern stipple{};
  int samples = 1;
};

/// Whether the fused tile loops can draw this: one sample, depth, and the everyday ways to blend.
constexpr bool is_everyday(const OutputState& s) noexcept {
  return s.samples == 1 && !s.stencil.enabled && s.alpha_test.test == Compare::always && s.fog.mode == FogMode::off &&
         s.blend.mode != BlendMode::function && s.blend.logic == LogicOperation::off && s.blend.mask.all() &&
         s.colour_format != ColourFormat::rgba16f && !s.multisampling.alpha_to_coverage;
}

/// The triangles of one chunk, ready to be drawn, with the attributes of their vertices.
struct ChunkView {
  const ScreenTriangle* triangles = nullptr;
  const TriangleExtent* extents = nullptr;  // one for each
  const float* attributes = nullptr;  // stride floats a vertex slot
  int stride = 0;
  const ScreenShape* shapes = nullptr;  // one for each of `triangles`; null when all are triangles
  const float* fog = nullptr;           // fog coordinate of each vertex slot, or its share if the fog is per vertex; null without fog
};

}  // namespace tuberia
