#include "reference/ray_tracer/geometry.hpp"

#include <algorithm>

#include "reference/ray_tracer/shapes/triangle.hpp"

namespace tuberia::tracer {

void Geometry::add_shape(std::shared_ptr<const Shape> shape, const glm::dmat4& world_from_object, int part) {
  const Placement placement(world_from_object);
  const Box bounds = placement.is_regular ? placement.to_world(shape->bounds()) : Box{};
  references_.push_back({.mesh = -1, .index = static_cast<std::int32_t>(shapes_.size())});
  shapes_.push_back({std::move(shape), placement, bounds, part});
}

void Geometry::add_mesh(const Mesh& mesh, const glm::dmat4& world_from_object, int part, bool facets) {
  const Placement placement(world_from_object);
  PlacedMesh placed;
  placed.part = part;
  placed.is_mirrored = placement.is_mirrored;
  placed.texcoords = mesh.texcoords;
  placed.colours = mesh.colours;
  for (const glm::vec3& position : mesh.positions) placed.positions.push_back(placement.point_to_world(position));
  if (!facets)
    for (const glm::vec3& normal : mesh.normals) placed.normals.push_back(placement.normal_to_world(normal));
  for (const glm::vec3& tangent : mesh.tangents) placed.tangents.push_back(placement.linear * glm::dvec3(tangent));
  for (const glm::vec3& bitangent : mesh.bitangents) placed.bitangents.push_back(placement.linear * glm::dvec3(bitangent));

  const auto number = static_cast<std::int32_t>(meshes_.size());
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    Corners corners{.vertices = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]}};
    // Before the matrix, too: afterwards rounding may have given an area to what had none.
    std::array<glm::dvec3, 3> in_object, in_world;
    for (std::size_t k = 0; k < 3; ++k) {
      in_object[k] = mesh.positions[corners.vertices[k]];
      in_world[k] = placed.positions[corners.vertices[k]];
    }
    corners.can_be_met = has_area(in_object) && has_area(in_world);
    references_.push_back({.mesh = number, .index = static_cast<std::int32_t>(placed.triangles.size())});
    placed.triangles.push_back(corners);
  }
  meshes_.push_back(std::move(placed));
}

Box Geometry::bounds(std::int64_t item) const noexcept {
  const Reference& of = reference(item);
  if (of.mesh < 0) return shapes_[static_cast<std::size_t>(of.index)].bounds;
  Box box;
  if (const auto corners = triangle(item))
    for (const glm::dvec3& corner : *corners) box.add(corner);
  return box;
}

BoundingSphere Geometry::bounding_sphere(std::int64_t item) const noexcept {
  const Reference& of = reference(item);
  if (of.mesh < 0) {
    const PlacedShape& placed = shapes_[static_cast<std::size_t>(of.index)];
    return placed.placement.to_world(placed.shape->bounding_sphere());
  }
  // Around the centroid, as far as the farthest corner [B 5.7.1].
  const std::array<glm::dvec3, 3> corners = meshes_[static_cast<std::size_t>(of.mesh)].corners_of(of.index);
  BoundingSphere sphere{.centre = (corners[0] + corners[1] + corners[2]) / 3.0};
  for (const glm::dvec3& corner : corners) sphere.radius = std::max(sphere.radius, glm::length(corner - sphere.centre));
  return sphere;
}

bool Geometry::intersect(std::int64_t item, const PreparedRay& ray, Hit& nearest) const noexcept {
  const Reference& of = reference(item);
  std::optional<ShapeHit> hit;
  if (of.mesh < 0) {
    const PlacedShape& placed = shapes_[static_cast<std::size_t>(of.index)];
    const Ray in_object = placed.placement.to_object(ray.ray);
    if (placed.placement.is_regular && is_sound(in_object)) hit = placed.shape->intersect(in_object);
  } else {
    const PlacedMesh& mesh = meshes_[static_cast<std::size_t>(of.mesh)];
    if (mesh.triangles[static_cast<std::size_t>(of.index)].can_be_met) hit = intersect_triangle(ray, mesh.corners_of(of.index));
  }
  if (!hit || !nearest.is_beaten_by(hit->t, item)) return false;
  nearest = {.t = hit->t, .item = item, .face = hit->face, .at = hit->at};
  return true;
}

int Geometry::part_of(std::int64_t item) const noexcept {
  const Reference& of = reference(item);
  return of.mesh < 0 ? shapes_[static_cast<std::size_t>(of.index)].part : meshes_[static_cast<std::size_t>(of.mesh)].part;
}

bool Geometry::is_convex(std::int64_t item) const noexcept {
  const Reference& of = reference(item);
  return of.mesh >= 0 || shapes_[static_cast<std::size_t>(of.index)].shape->is_convex();
}

std::optional<std::array<glm::dvec3, 3>> Geometry::triangle(std::int64_t item) const noexcept {
  const Reference& of = reference(item);
  if (of.mesh < 0) return std::nullopt;
  const PlacedMesh& mesh = meshes_[static_cast<std::size_t>(of.mesh)];
  if (!mesh.triangles[static_cast<std::size_t>(of.index)].can_be_met) return std::nullopt;
  return mesh.corners_of(of.index);
}

}  // namespace tuberia::tracer
