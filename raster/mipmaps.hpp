#pragma once
// Halving images, boxes of texels and cubes for mipmaps, in linear light.

#include <vector>

#include "image/image.hpp"

namespace tuberia {

/// A mipmap level before its rounding to codes: `slices` images one after the other.
struct LinearLevel {
  int width = 0, height = 0, slices = 0;
  std::vector<Rgba32F> texels;
};

/// The next coarser level, at least one texel each way: means over the halves; an odd size 2m+1 gives
/// m texels, each the weighted mean of three, so that every texel counts alike.     [A 1.1] [rules T6]
/// halve_slices: a box; otherwise each slice is an image of its own, such as the face of a cube.
LinearLevel halved(const LinearLevel& from, bool halve_slices);

}  // namespace tuberia
