#pragma once
// What lies around an object, as a function; environment maps are pictures of it, and conversions
// between kinds of maps go through it.                                      [A 1.4] [B 4.1.3] [FIX 16]

#include <array>
#include <functional>
#include <glm/vec3.hpp>

#include "image/image.hpp"

namespace tuberia {

/// Faces +x, -x, +y, -y, +z, -z of a cube map, squares of one size.
using CubeImages = std::array<Image<Rgba32F>, 6>;

struct Surroundings {
  /// Radiance, linear RGB, that comes from a unit direction.
  std::function<glm::dvec3(const glm::dvec3& direction)> radiance;
  /// The angle across which it changes: maps with larger texels take the mean of several directions in each.
  double detail_radians = 0.01;
};

// What a map shows, bilinear between texel centres. Panoramas join at their sides, cube maps at their
// edges. The images must not be empty.
Surroundings panorama_surroundings(Image<Rgba32F> panorama);
Surroundings cube_surroundings(CubeImages faces);
Surroundings sphere_map_surroundings(Image<Rgba32F> map);

// Maps of surroundings, alpha 1; sizes in texels, at least 1. Each texel is the mean over its area, in
// equal steps of its coordinates, by at most 16 x 16 samples. See scene/environment/directions.hpp.
Image<Rgba32F> panorama_of(const Surroundings& surroundings, int width, int height);
CubeImages cube_of(const Surroundings& surroundings, int size);
/// Square. Beyond the ball all is as on its rim, so that filtering there mixes in nothing else.
Image<Rgba32F> sphere_map_of(const Surroundings& surroundings, int size);

}  // namespace tuberia
