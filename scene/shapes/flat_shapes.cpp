#include "scene/shapes/flat_shapes.hpp"

#include <glm/geometric.hpp>

#include "scene/shapes/disc_grid.hpp"
#include "scene/shapes/surface_grid.hpp"

namespace tuberia {
namespace {

/// A rectangle around `centre`, from its left to its right edge along `right`, from its upper to its lower along `down`.
void append_face(Mesh& mesh, const glm::dvec3& centre, const glm::dvec3& right, const glm::dvec3& down, int columns, int rows) {
  const glm::dvec3 normal = glm::normalize(glm::cross(down, right));
  append_grid(mesh, columns, rows, [&](int column, int row) {
    const double u = static_cast<double>(column) / columns, v = static_cast<double>(row) / rows;
    return SurfacePoint{.position = centre + (u - 0.5) * right + (v - 0.5) * down, .normal = normal,
                        .tangent = right, .bitangent = down, .texcoord = {u, v}};
  });
}

}  // namespace

Result<Mesh> plane_mesh(const PlaneShape& shape) {
  ShapeCheck check("plane");
  check.positive("width", shape.width).positive("depth", shape.depth).count("columns", shape.columns, 1);
  check.count("rows", shape.rows, 1).product("columns * rows", shape.columns, shape.rows);
  if (check.error()) return *check.error();
  Mesh mesh;
  mesh.name = "plane";
  append_face(mesh, {0, 0, 0}, {shape.width, 0, 0}, {0, 0, shape.depth}, shape.columns, shape.rows);
  return mesh;
}

Result<Mesh> box_mesh(const BoxShape& shape) {
  ShapeCheck check("box");
  check.positive("width", shape.width).positive("height", shape.height).positive("depth", shape.depth);
  check.count("segments", shape.segments, 1).product("segments * segments", shape.segments, shape.segments);
  if (check.error()) return *check.error();
  const glm::dvec3 x(shape.width, 0, 0), y(0, shape.height, 0), z(0, 0, shape.depth);
  Mesh mesh;
  mesh.name = "box";
  const auto face = [&](const glm::dvec3& outwards, const glm::dvec3& right, const glm::dvec3& down) {
    append_face(mesh, 0.5 * outwards, right, down, shape.segments, shape.segments);
  };
  face(x, -z, -y);
  face(-x, z, -y);
  face(y, x, z);
  face(-y, x, -z);
  face(z, x, -y);
  face(-z, -x, -y);
  return mesh;
}

Result<Mesh> disc_mesh(const DiscShape& shape) {
  ShapeCheck check("disc");
  check.positive("radius", shape.radius).count("slices", shape.slices, 3).count("rings", shape.rings, 1);
  check.product("slices * rings", shape.slices, shape.rings);
  if (check.error()) return *check.error();
  Mesh mesh;
  mesh.name = "disc";
  append_disc(mesh, {.radius = shape.radius, .height = 0, .upwards = true, .slices = shape.slices, .rings = shape.rings});
  return mesh;
}

}  // namespace tuberia
