#pragma once
// Shapes of revolution about the y axis. On all of them u runs around the axis, counter-clockwise seen from
// above, from 0 at +x over 1/4 at -z to 1 at +x again; v runs down. Normals are those of the ideal shape.

#include "base/result.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// A sphere around the origin; v is the angle from the north pole, 0 at +y, 1 at -y. At the poles, where dP/du is
/// 0, each triangle has a vertex of its own, with the u of its middle.
struct SphereShape {
  double radius = 1;
  int slices = 48, stacks = 24;  // around the axis, from pole to pole
};

/// A cylinder centred at the origin; v is 0 at its upper rim, 1 at its lower. A cap is a disc with an image of its own.
struct CylinderShape {
  double radius = 1, height = 2;
  int slices = 48, stacks = 1;
  bool caps = true;
};

/// A cone centred at the origin, apex up, or a frustum of one if top_radius > 0. At the apex each triangle has a
/// vertex of its own, with the u and the normal of its middle. Caps: the base, and the top of a frustum.
struct ConeShape {
  double radius = 1, top_radius = 0, height = 2;
  int slices = 48, stacks = 1;
  bool caps = true;
};

/// A torus around the origin. v runs around the tube, from the circle nearest to the axis over the top: 1/4 on
/// the top, 1/2 at the outer equator, 3/4 on the bottom.
struct TorusShape {
  double radius = 1, tube_radius = 0.4;  // of the circle in the middle of the tube, and of the tube; the first larger
  int slices = 64, stacks = 32;          // around the axis, around the tube
};

/// The shapes. Errors: a length that is not positive and finite (top_radius: negative), fewer than 3 slices, fewer than 1
/// stack (sphere: 2, torus: 3), or too many of them.
Result<Mesh> sphere_mesh(const SphereShape& shape = {});
Result<Mesh> cylinder_mesh(const CylinderShape& shape = {});
Result<Mesh> cone_mesh(const ConeShape& shape = {});
Result<Mesh> torus_mesh(const TorusShape& shape = {});

}  // namespace tuberia
