#include "scene/shapes/round_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/shapes/disc_grid.hpp"
#include "scene/shapes/surface_grid.hpp"

namespace tuberia {
namespace {

constexpr double kPi = std::numbers::pi;

/// A direction from the axis, and the one in which it turns when u grows.
struct Meridian {
  glm::dvec3 outwards, around;
  double u;
};

/// half_steps: twice the column, so that the middle between two columns can be asked for.
Meridian meridian(int half_steps, int slices) {
  const glm::dvec2 point = point_on_unit_circle(half_steps, 2 * slices);
  return {{point.x, 0, 0.0 - point.y}, {0.0 - point.y, 0, 0.0 - point.x}, 0.5 * half_steps / slices};
}

/// Where rows meet in a point, a column's vertex serves the triangle to its right if the triangles hang
/// below the point, and the one to its left if they stand on it. One column too many is left, which repeats its neighbour.
enum class Pole { none, upper, lower };
Meridian meridian_at(int column, int slices, Pole pole) {
  if (pole == Pole::upper) return meridian(2 * std::min(column, slices - 1) + 1, slices);
  if (pole == Pole::lower) return meridian(2 * std::max(column, 1) - 1, slices);
  return meridian(2 * column, slices);
}

/// The side of a cone or cylinder, without caps; top_radius may be 0.
void append_side(Mesh& mesh, const ConeShape& cone) {
  const double flare = cone.radius - cone.top_radius;
  const double slant = std::hypot(flare, cone.height);
  append_grid(mesh, cone.slices, cone.stacks, [&](int column, int row) {
    const double v = static_cast<double>(row) / cone.stacks;
    const double radius = row == cone.stacks ? cone.radius : cone.top_radius + v * flare;
    const Meridian at = meridian_at(column, cone.slices, radius > 0 ? Pole::none : Pole::upper);
    const glm::dvec3 up(0, 1, 0);
    return SurfacePoint{.position = radius * at.outwards + (0.5 - v) * cone.height * up,
                        .normal = (cone.height * at.outwards + flare * up) / slant,
                        .tangent = 2 * kPi * radius * at.around,
                        .bitangent = flare * at.outwards - cone.height * up, .texcoord = {at.u, v}};
  });
}

ShapeCheck check_of(const char* name, double radius, double height, int slices, int stacks) {
  ShapeCheck check(name);
  check.positive("radius", radius).positive("height", height).count("slices", slices, 3).count("stacks", stacks, 1);
  check.product("slices * stacks", slices, stacks);
  return check;
}

Mesh cone_of(const char* name, const ConeShape& cone) {
  Mesh mesh;
  mesh.name = name;
  append_side(mesh, cone);
  if (!cone.caps) return mesh;
  const double half = 0.5 * cone.height;
  if (cone.top_radius > 0) append_disc(mesh, {.radius = cone.top_radius, .height = half, .upwards = true, .slices = cone.slices});
  append_disc(mesh, {.radius = cone.radius, .height = -half, .upwards = false, .slices = cone.slices});
  return mesh;
}

}  // namespace

Result<Mesh> sphere_mesh(const SphereShape& shape) {
  ShapeCheck check("sphere");
  check.positive("radius", shape.radius).count("slices", shape.slices, 3).count("stacks", shape.stacks, 2);
  check.product("slices * stacks", shape.slices, shape.stacks);
  if (check.error()) return *check.error();

  Mesh mesh;
  mesh.name = "sphere";
  append_grid(mesh, shape.slices, shape.stacks, [&](int column, int row) {
    const Pole pole = row == 0 ? Pole::upper : row == shape.stacks ? Pole::lower : Pole::none;
    const Meridian at = meridian_at(column, shape.slices, pole);
    const glm::dvec2 polar = point_on_unit_circle(row, 2 * shape.stacks);  // from the north pole: along it, and across
    const glm::dvec3 up(0, 1, 0);
    const glm::dvec3 normal = polar.y * at.outwards + polar.x * up;
    return SurfacePoint{.position = shape.radius * normal, .normal = normal,
                        .tangent = 2 * kPi * shape.radius * polar.y * at.around,
                        .bitangent = kPi * shape.radius * (polar.x * at.outwards - polar.y * up),
                        .texcoord = {at.u, static_cast<double>(row) / shape.stacks}};
  });
  return mesh;
}

Result<Mesh> cylinder_mesh(const CylinderShape& shape) {
  const ShapeCheck check = check_of("cylinder", shape.radius, shape.height, shape.slices, shape.stacks);
  if (check.error()) return *check.error();
  return cone_of("cylinder", {.radius = shape.radius, .top_radius = shape.radius, .height = shape.height, .slices = shape.slices,
                              .stacks = shape.stacks, .caps = shape.caps});
}

Result<Mesh> cone_mesh(const ConeShape& shape) {
  ShapeCheck check = check_of("cone", shape.radius, shape.height, shape.slices, shape.stacks);
  check.require(std::isfinite(shape.top_radius) && shape.top_radius >= 0, "top_radius", shape.top_radius, "finite and at least 0");
  if (check.error()) return *check.error();
  return cone_of("cone", shape);
}

Result<Mesh> torus_mesh(const TorusShape& shape) {
  ShapeCheck check("torus");
  check.positive("radius", shape.radius).positive("tube_radius", shape.tube_radius);
  check.require(shape.tube_radius < shape.radius, "tube_radius", shape.tube_radius, "less than radius");
  check.count("slices", shape.slices, 3).count("stacks", shape.stacks, 3).product("slices * stacks", shape.slices, shape.stacks);
  if (check.error()) return *check.error();

  Mesh mesh;
  mesh.name = "torus";
  append_grid(mesh, shape.slices, shape.stacks, [&](int column, int row) {
    const Meridian at = meridian_at(column, shape.slices, Pole::none);
    const glm::dvec2 tube = point_on_unit_circle(row, shape.stacks);  // from the inner equator, over the top
    const glm::dvec3 up(0, 1, 0);
    const glm::dvec3 normal = tube.y * up - tube.x * at.outwards;
    return SurfacePoint{.position = shape.radius * at.outwards + shape.tube_radius * normal, .normal = normal,
                        .tangent = 2 * kPi * (shape.radius - shape.tube_radius * tube.x) * at.around,
                        .bitangent = 2 * kPi * shape.tube_radius * (tube.x * up + tube.y * at.outwards),
                        .texcoord = {at.u, static_cast<double>(row) / shape.stacks}};
  });
  return mesh;
}

}  // namespace tuberia
