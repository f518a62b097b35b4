#pragma once
// Shapes of plane faces.

#include "base/result.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// A rectangle on the ground, y = 0, seen from above, centred at the origin. u runs along x, v along z:
/// the upper edge of an image lies at -z.
struct PlaneShape {
  double width = 2, depth = 2;   // along x and z, world units
  int columns = 1, rows = 1;     // quadrilaterals along x and z
};

/// A box along the axes, centred at the origin. Each face has the whole image, upright on the sides; the
/// image's upper edge is at -z on the top and at +z on the bottom. Corners and edges are sharp: every face
/// has vertices of its own.
struct BoxShape {
  double width = 2, height = 2, depth = 2;  // along x, y and z
  int segments = 1;                         // quadrilaterals along each edge
};

/// A disc on the ground, y = 0, seen from above, centred at the origin. The image's square surrounds it: u runs
/// along x, v along z, both 0.5 in the middle.
struct DiscShape {
  double radius = 1;
  int slices = 48, rings = 1;    // around, and from the middle to the rim
};

/// The shapes. Errors: a length that is not positive and finite, a count below 1 (slices: below 3) or too large.
Result<Mesh> plane_mesh(const PlaneShape& shape = {});
Result<Mesh> box_mesh(const BoxShape& shape = {});
Result<Mesh> disc_mesh(const DiscShape& shape = {});

}  // namespace tuberia
