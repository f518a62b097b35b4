#include <algorithm>
#include <cmath>

#include "reference/ray_tracer/geometry.hpp"

namespace tuberia::tracer {
namespace {

template <class Vector>
auto mean(const std::vector<Vector>& attribute, const std::array<std::uint32_t, 3>& vertices, const glm::dvec3& weights) {
  using Exact = glm::vec<Vector::length(), double>;
  return weights.x * Exact(attribute[vertices[0]]) + weights.y * Exact(attribute[vertices[1]]) + weights.z * Exact(attribute[vertices[2]]);
}

glm::dvec3 unit_or(const glm::dvec3& vector, const glm::dvec3& otherwise) noexcept {
  const double length = glm::length(vector);
  return length > 0 && std::isfinite(length) ? vector / length : otherwise;
}

double magnitude_of(const glm::dvec3& point) noexcept { return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}); }

}  // namespace

SurfacePoint Geometry::surface(const Ray& ray, const Hit& hit) const noexcept {
  const Reference& of = reference(hit.item);
  if (of.mesh >= 0) return meshes_[static_cast<std::size_t>(of.mesh)].surface(of.index, {1 - hit.at.x - hit.at.y, hit.at.x, hit.at.y});

  const PlacedShape& placed = shapes_[static_cast<std::size_t>(of.index)];
  const Placement& placement = placed.placement;
  SurfacePoint point = placed.shape->surface(placement.to_object(ray), {.t = hit.t, .face = hit.face, .at = hit.at});
  point.magnitude = placement.magnitude_to_world(point.magnitude);
  point.position = placement.point_to_world(point.position);
  point.geometric_normal = placement.normal_to_world(point.geometric_normal);
  point.normal = placement.normal_to_world(point.normal);
  point.tangent = placement.linear * point.tangent;
  point.bitangent = placement.linear * point.bitangent;
  return point;
}

std::array<glm::dvec3, 3> Geometry::PlacedMesh::corners_of(std::int32_t triangle) const noexcept {
  const std::array<std::uint32_t, 3>& vertices = triangles[static_cast<std::size_t>(triangle)].vertices;
  return {positions[vertices[0]], positions[vertices[1]], positions[vertices[2]]};
}

SurfacePoint Geometry::PlacedMesh::surface(std::int32_t triangle, const glm::dvec3& weights) const noexcept {
  const std::array<std::uint32_t, 3>& vertices = triangles[static_cast<std::size_t>(triangle)].vertices;
  const std::array<glm::dvec3, 3> corners = corners_of(triangle);
  SurfacePoint point;
  point.position = mean(positions, vertices, weights);
  point.magnitude = std::max({magnitude_of(corners[0]), magnitude_of(corners[1]), magnitude_of(corners[2])});

  // Of sides that are not longer than 1, so that areas of very large and very small triangles stay numbers.
  const glm::dvec3 first = corners[1] - corners[0], second = corners[2] - corners[0];
  const double size = std::max(magnitude_of(first), magnitude_of(second));
  const glm::dvec3 area = glm::cross(first / size, second / size);
  point.geometric_normal = unit_or(is_mirrored ? -area : area, {0, 0, 1});
  point.normal = normals.empty() ? point.geometric_normal : unit_or(mean(normals, vertices, weights), point.geometric_normal);
  if (!texcoords.empty()) point.texcoord = mean(texcoords, vertices, weights);
  if (!colours.empty()) point.colour = glm::dvec3(mean(colours, vertices, weights));
  find_tangents(point, triangle, weights);
  return point;
}

void Geometry::PlacedMesh::find_tangents(SurfacePoint& point, std::int32_t triangle, const glm::dvec3& weights) const noexcept {
  const std::array<std::uint32_t, 3>& vertices = triangles[static_cast<std::size_t>(triangle)].vertices;
  if (!tangents.empty() && !bitangents.empty()) {
    point.tangent = mean(tangents, vertices, weights);
    point.bitangent = mean(bitangents, vertices, weights);
    return;
  }
  if (!texcoords.empty()) {
    const std::array<glm::dvec3, 3> corners = corners_of(triangle);
    const glm::dvec3 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0];
    const glm::dvec2 d1 = texcoords[vertices[1]] - texcoords[vertices[0]], d2 = texcoords[vertices[2]] - texcoords[vertices[0]];
    const double determinant = d1.x * d2.y - d2.x * d1.y;  // [A 1.2]
    // What is smaller is rounding.
    if (std::abs(determinant) > 1e-6 * glm::length(d1) * glm::length(d2)) {
      point.tangent = (d2.y * e1 - d1.y * e2) / determinant;
      point.bitangent = (d1.x * e2 - d2.x * e1) / determinant;
      return;
    }
  }
  const glm::dvec3 axis = std::abs(point.normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  point.tangent = glm::normalize(axis - glm::dot(axis, point.normal) * point.normal);
  point.bitangent = glm::cross(point.tangent, point.normal);
}

}  // namespace tuberia::tracer
