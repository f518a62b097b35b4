#pragma once
// What a frame costs, pixel by pixel and tile by tile.

#include "image/image.hpp"
#include "pipeline/observer.hpp"

namespace tuberia::cli {

/// Which primitive a pixel shows; numbers count from 0.
struct Owner {
  int draw = -1;                 // -1: none
  std::uint32_t primitive = 0;
  bool operator==(const Owner&) const = default;
};

/// Watches all draws of a frame.
class FrameMaps : public Observer {
 public:
  FrameMaps(int width_pixels, int height_pixels);

  void begin(const DrawCall&, const AcceptedDraw&) override { ++draw_; }
  void after(Stage stage, const Chunk& chunk) override;
  void after(Stage stage, const Chunk& chunk, const FragmentBlock& block, const Tile& tile) override;

  Image<float> overdraw;        // fragments that covered the pixel, hidden ones included
  Image<float> triangle_size;   // area in pixels of the triangle that the pixel shows; 0: none
  Image<float> tile_load;       // primitives in the list of the pixel's tile
  Image<Owner> owner;

 private:
  template <class Body>
  void for_each_live(const FragmentBlock& block, Body&& body);

  int draw_ = -1, tiles_per_row_;
};

}  // namespace tuberia::cli
