#pragma once
// Surfaces of bicubic Bezier patches.

#include <array>
#include <vector>

#include "base/result.hpp"
#include "scene/shapes/surface_grid.hpp"

namespace tuberia {

/// Sixteen control points, row by row: s runs along a row, t from row to row, both 0..1. The outside is where
/// s runs to the right and t down. An image's rectangle from texcoord_from to texcoord_to covers the patch.
struct BezierPatch {
  std::array<glm::dvec3, 16> points{};
  glm::dvec2 texcoord_from{0, 0}, texcoord_to{1, 1};  // at (s, t) = (0, 0) and (1, 1); they differ in both coordinates

  const glm::dvec3& point(int row, int column) const { return points[static_cast<std::size_t>(4 * row + column)]; }
};

/// The patch at (s, t), with its derivatives by the texture coordinates. Where both derivatives, or one of
/// them, vanish (an edge drawn together to a point), the normal is its limit from inside the patch;
/// (0, 1, 0) if the whole patch has no area.
SurfacePoint evaluate(const BezierPatch& patch, double s, double t);

struct BezierShape {
  std::vector<BezierPatch> patches;
  int segments = 8;                      // quadrilaterals along each edge of each patch
};

/// Patches side by side. The positions along an edge depend on its four control points only, to the last bit and in
/// either direction, so that neighbours leave no gap. Errors: no patches, a control point that is not finite, an empty
/// rectangle of texture coordinates, segments below 1, too many quadrilaterals.
Result<Mesh> bezier_mesh(const BezierShape& shape);

}  // namespace tuberia
