#pragma once
// Blocks of fragments made by hand, and a target of one tile to put them on.

#include <array>
#include <memory>
#include <span>

#include "raster/fragment_block.hpp"
#include "raster/render_target.hpp"

namespace tuberia::test {

/// One block's worth of numbers, in the order of index_in_block.
using BlockFloats = std::array<float, kBlockPixels>;

/// A block at the target's origin whose fragment i has depth depths[i], every bit of it: the
/// triangle's depth is its first weight.
class DepthBlock {
 public:
  explicit DepthBlock(const BlockFloats& depths, std::uint64_t live = ~std::uint64_t{0}) {
    triangle_.depth_delta[0] = 1;
    block_.triangle = &triangle_;
    block_.live = block_.sample_live[0] = live;
    std::copy(depths.begin(), depths.end(), block_.depth_value[0]);
  }
  DepthBlock(const DepthBlock&) = delete;
  FragmentBlock& block() { return block_; }

 private:
  ScreenTriangle triangle_{};
  FragmentBlock block_;
};

inline FragmentBlock colour_block(const std::array<Rgba32F, kBlockPixels>& colours, std::uint64_t live = ~std::uint64_t{0}) {
  FragmentBlock block;
  block.live = block.sample_live[0] = live;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const float channels[4] = {colours[i].r, colours[i].g, colours[i].b, colours[i].a};
    for (std::size_t c = 0; c < 4; ++c) block.colour[c][i] = channels[c];
  }
  return block;
}

/// A target of one block, cleared.
inline RenderTarget small_target(ColourFormat colour, DepthFormat depth, const Rgba32F& background = {0, 0, 0, 0}, float far_depth = 1) {
  RenderTarget target = *RenderTarget::create(kBlockSize, kBlockSize, colour, depth);
  Workers workers(1);
  target.clear_colour(background, workers);
  target.clear_depth(far_depth, workers);
  return target;
}

/// An image of one block in the order of index_in_block.
template <class Pixel>
std::array<Pixel, kBlockPixels> in_block_order(const Image<Pixel>& image) {
  std::array<Pixel, kBlockPixels> pixels;
  for (int i = 0; i < kBlockPixels; ++i) pixels[static_cast<std::size_t>(i)] = image.at(block_x(i), block_y(i));
  return pixels;
}

inline OutputState output_state(ColourFormat colour, DepthFormat depth) {
  return {.depth = {}, .blend = {}, .depth_format = depth, .colour_format = colour, .clip = {0, 0, kBlockSize, kBlockSize}};
}

}  // namespace tuberia::test
