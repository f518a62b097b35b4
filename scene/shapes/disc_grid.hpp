#pragma once
// A disc as part of a shape.

#include "scene/mesh.hpp"

namespace tuberia {

/// A disc parallel to the ground around the y axis. Seen from its front, the image's square surrounds it; u runs along x.
struct DiscGrid {
  double radius = 1, height = 0;  // height: the y of the disc
  bool upwards = true;            // its front looks to +y, or to -y
  int slices = 48, rings = 1;
};

/// The disc must be sensible: radius > 0, slices >= 3, rings >= 1.
void append_disc(Mesh& mesh, const DiscGrid& disc);

}  // namespace tuberia
