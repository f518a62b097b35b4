#pragma once
// Convex polygons as triangles.

#include "base/result.hpp"
#include "scene/description/shape.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// A fan. The image covers the rectangle around the outline, as on the side of a box that looks most like it: see box_mesh.
/// Errors: no area, and, since they can only be traced, holes and outlines that are not convex.
Result<Mesh> polygon_mesh(const description::Polygon& polygon);

}  // namespace tuberia
