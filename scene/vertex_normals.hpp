#pragma once
// Normals and tangents of a net of triangles that comes without them.                 [B 3.2] [A 1.2]

#include <numbers>

#include "base/result.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// What each polygon counts for in the mean at a vertex. equal: as much as any other, triangles in one
/// plane that share an edge being one polygon [B 3.2]; by_angle: its angle at the vertex, which does not depend on how a
/// polygon was cut in triangles either, and less on how the surface was cut in polygons.
enum class NormalWeight { equal, by_angle };

struct NormalRule {
  double crease_angle_radians = std::numbers::pi;  // edges whose two normals differ by more stay sharp; 0..pi
  NormalWeight weight = NormalWeight::equal;
};

/// The mesh with normals made anew: at each position the normalized mean of the normals of the polygons that meet
/// there. Polygons on different sides of sharp edges are averaged apart, and the vertex is split [B 3.2.1].
/// Equal positions are one point, so that seams of the texture do not show. A triangle without area counts for nothing and
/// takes the normals of others at its vertices, (0, 0, 1) if there are none. Existing tangents are kept as they are.
/// Error: a crease angle outside 0..pi.
Result<Mesh> with_vertex_normals(Mesh mesh, const NormalRule& rule = {});

/// The mesh with the normal of its plane at every corner of a triangle, no vertices shared between planes.
Mesh with_facet_normals(Mesh mesh);

/// Tangents from the texture coordinates: of a triangle p0, p1, p2 with sides e1, e2 that change (u, v) by (a1, b1), (a2, b2):
///     t_u = (b2 e1 - b1 e2) / det,  t_v = (a1 e2 - a2 e1) / det,  det = a1 b2 - a2 b1                 [A 1.2]
/// by_polygon: constant on each triangle, which shares no vertices. by_vertex: the mean of the triangles that share the vertex (see
/// join_identical_vertices), by their angles there, in the plane perpendicular to its normal; where mirrored texture
/// coordinates meet others, the vertex is split, so that no mean mixes both. Lengths stay: dP/du, not unit.
/// A triangle without area, or whose texture coordinates have none, counts for nothing; where there is nothing else, the tangents are
/// unit vectors perpendicular to the normal and to each other, with the normal along t_v x t_u as for an unmirrored image.
enum class TangentKind { by_polygon, by_vertex };

/// Error: no texture coordinates, or by_vertex without normals.
Result<Mesh> with_tangents(Mesh mesh, TangentKind kind = TangentKind::by_vertex);

}  // namespace tuberia
