#pragma once
// What a mesh from a file may lack.

#include "scene/mesh.hpp"

namespace tuberia {

/// Replaces the normals by smooth ones: at each position the sum of the normals of all triangles
/// that touch it, weighted by their areas. Equal positions get equal normals, whatever their
/// texture coordinates, so that no seam shows. (0, 0, 1) where no triangle has an area.
/// Only sums, products and square roots: the same bits on every machine.
void make_smooth_normals(Mesh& mesh);

/// Joins vertices of the same bits in every attribute (0 and -0 are the same), and drops those
/// that no index uses. The triangles stay as they are, in their order; vertices are numbered as
/// the indices first meet them.
void join_identical_vertices(Mesh& mesh);

}  // namespace tuberia
