#pragma once
// Newell's teapot.                                                                     [Newell]

#include <vector>

#include "scene/shapes/bezier_patches.hpp"

namespace tuberia {

/// The teapot of 32 patches, standing on y = 0 with the spout along +x: x from -3 to 3.44, y from 0 to 3.15, z from
/// -2 to 2. As published it is open between the body (radius 1.4) and the lid (1.3), at the tip of the spout, and
/// where handle and spout stick in the body. Lid, body, handle and spout have an image each (the bottom shares the body's):
/// u around, v from the knob down, from the rim down and on to the middle of the bottom, from the body along the handle and the spout.
struct TeapotShape {
  int segments = 8;      // quadrilaterals along each edge of each patch
  bool bottom = true;    // the four patches of the bottom, which Newell's drawing lacked
  bool lid = true;
};

/// Error: segments below 1 or too many.
Result<Mesh> teapot_mesh(const TeapotShape& shape = {});

/// The patches themselves, in the order lid (8), body (12), bottom (4), handle (4), spout (4).
std::vector<BezierPatch> teapot_patches();

}  // namespace tuberia
