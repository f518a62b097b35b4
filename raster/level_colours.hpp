#pragma once
// A texture that shows which of its levels is read.                                    [A 1.1]

#include "raster/texture.hpp"

namespace tuberia {

/// A level's colour, linear codes: red, yellow, green, cyan, blue, magenta for levels 0 to 5, then darker ones of the same.
Rgba8 level_colour(int level) noexcept;

/// A texture of that size, 1..Texture::kMaxSize each way, each of whose levels has its level_colour all
/// over. Between the levels trilinear filtering mixes the colours.
Result<Texture> level_coloured_texture(int width, int height);

}  // namespace tuberia
