#include "examples/tuberia/frame_maps.hpp"

#include <algorithm>

namespace tuberia::cli {

FrameMaps::FrameMaps(int width_pixels, int height_pixels)
    : overdraw(width_pixels, height_pixels), triangle_size(width_pixels, height_pixels), tile_load(width_pixels, height_pixels),
      owner(width_pixels, height_pixels), tiles_per_row_((width_pixels + kTileSize - 1) / kTileSize) {}

void FrameMaps::after(Stage stage, const Chunk& chunk) {
  if (stage != Stage::binning) return;
  for (int number = 0; number < chunk.tiles.tile_count(); ++number) {
    const auto load = static_cast<float>(chunk.tiles.of_tile(number).size());
    const int left = number % tiles_per_row_ * kTileSize, top = number / tiles_per_row_ * kTileSize;
    for (int y = top; load > 0 && y < std::min(top + kTileSize, tile_load.height()); ++y)
      for (int x = left; x < std::min(left + kTileSize, tile_load.width()); ++x) tile_load.at(x, y) += load;
  }
}

template <class Body>
void FrameMaps::for_each_live(const FragmentBlock& block, Body&& body) {
  for (int i = 0; i < kBlockPixels; ++i)
    if ((block.live >> i & 1u) != 0) body(block.left + block_x(i), block.top + block_y(i));
}

void FrameMaps::after(Stage stage, const Chunk&, const FragmentBlock& block, const Tile&) {
  if (stage == Stage::rasterization) for_each_live(block, [&](int x, int y) { overdraw.at(x, y) += 1; });
  if (stage != Stage::blending) return;
  // The weights' scale is 256 over twice the area in square units, of which a pixel has 65536.
  const float scale = block.triangle->weight_scale;
  const float area_pixels = scale > 0 ? 1 / (512 * scale) : 0;
  for_each_live(block, [&](int x, int y) {
    owner.at(x, y) = {draw_, block.triangle->primitive};
    triangle_size.at(x, y) = area_pixels;
  });
}

}  // namespace tuberia::cli
