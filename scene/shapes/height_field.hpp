#pragma once
// Landscapes: a height over each point of the ground.

#include <functional>

#include "base/result.hpp"
#include "image/image.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// A height in world units, and how it changes along one unit of u and of v.
struct Height {
  double value = 0, slope_u = 0, slope_v = 0;
};

/// A height field over a rectangle of the ground, centred at the origin. Texture coordinates as on a plane: u along x, v along z.
struct HeightFieldShape {
  double width = 2, depth = 2;      // along x and z, world units
  int columns = 64, rows = 64;      // quadrilaterals along x and z
};

/// Heights by a function of (u, v), both 0..1, called once for each vertex; its slopes give the normals.
/// Errors: as for plane_mesh, and a height or slope that is not finite.
Result<Mesh> height_field_mesh(const HeightFieldShape& shape, const std::function<Height(double u, double v)>& height);

/// Heights by a picture, red 0 for 0 and 1 (of 8 bits: 255) for `tallest`. Texel centres carry the
/// heights; between them they are interpolated linearly, beyond the outer ones they stay the same. Slopes are central differences over
/// one texel each way.
/// Errors: as above, an empty picture, a `tallest` that is not finite.
Result<Mesh> height_field_mesh(const HeightFieldShape& shape, const Image<Rgba8>& picture, double tallest);
Result<Mesh> height_field_mesh(const HeightFieldShape& shape, const Image<Rgba32F>& picture, double tallest);

}  // namespace tuberia
