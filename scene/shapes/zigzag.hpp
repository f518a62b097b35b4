#pragma once
// A folded strip, on which averaged normals fail.                                       [B 3.2.1]

#include "base/result.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// A strip along x, folded up and down by turns, centred at the origin, seen from above; u runs along x over the whole strip, v along z.
/// At every fold the mean of the two flanks' normals is vertical, so that with averaged normals the strip is lit as if it
/// were flat; flanks that are cut in more strips have vertices of their own between the folds.
struct ZigzagShape {
  double width = 4, depth = 2, height = 0.4;  // along x and z, and from the troughs to the ridges
  int flanks = 8;             // along x
  int strips_per_flank = 1;   // quadrilaterals that each flank is cut in along x
};

/// Every flank has vertices and normals of its own: see with_vertex_normals for the mean ones.
/// Errors: as of plane_mesh.
Result<Mesh> zigzag_mesh(const ZigzagShape& shape = {});

}  // namespace tuberia
