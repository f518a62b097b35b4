#pragma once
// What rays are sent at when their speed is measured: made by formulas, the same on every machine.

#include <cstdint>
#include <vector>

#include "reference/ray_tracer/geometry.hpp"

namespace tuberia::bench {

/// So many equal spheres anywhere in the cube from -1 to 1: the fewer, the larger, so that a ray meets one after
/// about the same way whatever their number.
tracer::Geometry random_spheres(std::int64_t count);

/// Hilly ground over the square from -1 to 1: a net of so many triangles, an even number.
tracer::Geometry hills(std::int64_t triangle_count);

/// Half of them from an eye outside the cube through the pixels of a picture, half from anywhere in it to anywhere, as
/// light goes from surface to surface; in no order.
std::vector<tracer::Ray> mixed_rays(int count);

/// The rays of a square picture, row by row.
std::vector<tracer::Ray> eye_rays(int pixels_wide);

}  // namespace tuberia::bench
