#include <glm/ext/vector_double2.hpp>
#include <vector>

#include "scene/mesh_vertices.hpp"
#include "scene/triangle_corners.hpp"
#include "scene/vertex_normals.hpp"

namespace tuberia {
namespace {

// Twice an area of texture coordinates this small against the sides' lengths is rounding noise.
constexpr double kNoTextureArea = 1e-6;

/// dP/du and dP/dv. mirrored: whether an image appears mirrored from the triangle's front.
struct Tangents {
  glm::dvec3 u{0}, v{0};
  bool exist = false, mirrored = false;
};

glm::dvec2 texcoord_at(const Mesh& mesh, std::uint32_t corner) { return mesh.texcoords[mesh.indices[corner]]; }

Tangents tangents_of(const Mesh& mesh, std::uint32_t triangle) {
  const std::uint32_t corner = 3 * triangle;
  const glm::dvec3 e1 = position_at(mesh, corner + 1) - position_at(mesh, corner);
  const glm::dvec3 e2 = position_at(mesh, corner + 2) - position_at(mesh, corner);
  const glm::dvec2 d1 = texcoord_at(mesh, corner + 1) - texcoord_at(mesh, corner);
  const glm::dvec2 d2 = texcoord_at(mesh, corner + 2) - texcoord_at(mesh, corner);
  const double determinant = d1.x * d2.y - d2.x * d1.y;
  const bool has_area = std::abs(determinant) > kNoTextureArea * glm::length(d1) * glm::length(d2);
  if (!has_area || unit_normal(mesh, triangle) == glm::dvec3(0)) return {};
  return {.u = (d2.y * e1 - d1.y * e2) / determinant, .v = (d1.x * e2 - d2.x * e1) / determinant, .exist = true,
          .mirrored = determinant > 0};  // v runs down the image: counter-clockwise on both is a mirror image
}

glm::dvec3 without_part_along(const glm::dvec3& vector, const glm::dvec3& unit) { return vector - glm::dot(vector, unit) * unit; }

/// Unit, perpendicular to the normal and to each other, as of an unmirrored image.
Tangents some_tangents(const glm::dvec3& normal) {
  const glm::dvec3 axis = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(without_part_along(axis, normal));
  return {.u = u, .v = glm::cross(u, normal)};
}

void write(Mesh& mesh, std::uint32_t vertex, const Tangents& tangents) {
  mesh.tangents[vertex] = glm::vec3(tangents.u);
  mesh.bitangents[vertex] = glm::vec3(tangents.v);
}

Mesh by_polygon(Mesh mesh, const std::vector<Tangents>& of_triangle) {
  std::vector<std::uint32_t> variants(mesh.indices.size());
  for (std::uint32_t corner = 0; corner < variants.size(); ++corner) variants[corner] = corner / 3;
  split_vertices(mesh, variants);
  mesh.tangents.resize(mesh.positions.size());
  mesh.bitangents.resize(mesh.positions.size());
  for (std::uint32_t corner = 0; corner < mesh.indices.size(); ++corner) {
    const Tangents& own = of_triangle[corner / 3];
    write(mesh, mesh.indices[corner], own.exist ? own : some_tangents(unit_or(unit_normal(mesh, corner / 3), {0, 0, 1})));
  }
  return mesh;
}

Mesh by_vertex(Mesh mesh, const std::vector<Tangents>& of_triangle) {
  // A triangle without tangents of its own goes with the unmirrored ones.
  std::vector<std::uint32_t> variants(mesh.indices.size());
  for (std::uint32_t corner = 0; corner < variants.size(); ++corner) variants[corner] = of_triangle[corner / 3].mirrored ? 1 : 0;
  split_vertices(mesh, variants);

  std::vector<Tangents> sums(mesh.positions.size());
  std::vector<double> weights(mesh.positions.size(), 0.0);
  for (std::uint32_t corner = 0; corner < mesh.indices.size(); ++corner) {
    const Tangents& own = of_triangle[corner / 3];
    if (!own.exist) continue;
    const std::uint32_t vertex = mesh.indices[corner];
    const double weight = angle_at(mesh, corner);
    sums[vertex].u += weight * own.u;
    sums[vertex].v += weight * own.v;
    weights[vertex] += weight;
  }
  mesh.tangents.resize(mesh.positions.size());
  mesh.bitangents.resize(mesh.positions.size());
  for (std::uint32_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    const glm::dvec3 normal = unit_or(mesh.normals[vertex], {0, 0, 1});
    const Tangents mean{.u = without_part_along(sums[vertex].u / weights[vertex], normal),
                        .v = without_part_along(sums[vertex].v / weights[vertex], normal)};
    const bool spans = weights[vertex] > 0 && glm::length(glm::cross(mean.u, mean.v)) > 0;
    write(mesh, vertex, spans ? mean : some_tangents(normal));
  }
  return mesh;
}

}  // namespace

Result<Mesh> with_tangents(Mesh mesh, TangentKind kind) {
  if (mesh.texcoords.empty()) return Error{"mesh '" + mesh.name + "' has no texture coordinates, so it has no tangents"};
  if (kind == TangentKind::by_vertex && mesh.normals.empty()) return Error{"mesh '" + mesh.name + "' has no normals for tangents at its vertices"};
  std::vector<Tangents> of_triangle(mesh.indices.size() / 3);
  for (std::uint32_t triangle = 0; triangle < of_triangle.size(); ++triangle) of_triangle[triangle] = tangents_of(mesh, triangle);
  return kind == TangentKind::by_polygon ? by_polygon(std::move(mesh), of_triangle) : by_vertex(std::move(mesh), of_triangle);
}

}  // namespace tuberia
