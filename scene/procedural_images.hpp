#pragma once
// Pictures that are computed instead of loaded, for textures of scenes without files. Colours are sRGB codes,
// heights and normals linear ones. Sizes in pixels, at least 1 each way.

#include <cstdint>

#include "image/image.hpp"
#include "math/patterns.hpp"

namespace tuberia {

/// A checker or random squares over one unit of u and of v, each pixel the mean over its own area; solid
/// patterns over the square z = 0 of their space, with y upwards.
Image<Rgba8> pattern_image(const Pattern& pattern, int width, int height);

/// An invented planet for sphere mapping: u its longitude, rows from the north pole down; sea, coasts,
/// land that is green, dry or high, and ice towards the poles. Without a seam.     [B 4.1]
Image<Rgba8> planet_image(int width, int height, std::uint32_t seed = 1);
/// Its heights: 0 for sea and ice, up to white for mountains.
Image<Rgba8> planet_height_image(int width, int height, std::uint32_t seed = 1);

/// Bricks in running bond, `courses` (an even number) rows of them, half as many in a row; mortar between.
Image<Rgba8> brick_image(int width, int height, int courses = 8, std::uint32_t seed = 1);
/// Its heights: mortar black, bricks white with rounded rims.
Image<Rgba8> brick_height_image(int width, int height, int courses = 8);

/// Round bumps, `count` along each side.                                             [B Fig 23]
Image<Rgba8> stud_height_image(int width, int height, int count);

/// The picture of normals (BumpMap::Kind::normal_map) of a picture of heights by its red, which repeats beyond its
/// borders, by central differences over a pixel each way. relief: the height of white, in the picture's widths.
Image<Rgba8> normal_image(const Image<Rgba8>& heights, double relief);

}  // namespace tuberia
