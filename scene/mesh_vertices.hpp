#pragma once
// Work on the vertices of a mesh, whatever attributes it has.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/mesh.hpp"

namespace tuberia {

/// Calls visit(attribute) for each vector of the mesh that has one entry per position, or is empty.
template <class AnyMesh, class Visit>
void for_each_attribute(AnyMesh& mesh, Visit visit) {
  visit(mesh.positions);
  visit(mesh.normals);
  visit(mesh.tangents);
  visit(mesh.bitangents);
  visit(mesh.texcoords);
  visit(mesh.colours);
}

/// Vertex i becomes what vertex chosen[i] was, in every attribute. The indices stay.
void choose_vertices(Mesh& mesh, std::span<const std::uint32_t> chosen);

/// For each vertex a number less than the number of different positions; equal for equal positions, to the bit (0 and -0
/// are the same), and counted in the order in which vertices first have them.
std::vector<std::uint32_t> position_numbers(const Mesh& mesh);

/// One entry per index: corners of triangles that share a vertex go on sharing one only if they have the same
/// variant. Vertices are numbered as the indices first meet them; those that no index uses are dropped.
void split_vertices(Mesh& mesh, std::span<const std::uint32_t> variant_of_corner);

}  // namespace tuberia
