// A shape traced exactly looks like its tessellation.
#include <catch2/catch.hpp>

#include "reference/ray_tracer/shapes/cuboid.hpp"
#include "reference/ray_tracer/shapes/flat_shapes.hpp"
#include "reference/ray_tracer/shapes/polygon.hpp"
#include "reference/ray_tracer/shapes/polyhedron.hpp"
#include "reference/ray_tracer/shapes/round_shapes.hpp"
#include "reference/ray_tracer/shapes/sphere.hpp"
#include "reference/ray_tracer/shapes/torus.hpp"
#include "scene/shapes/shapes.hpp"
#include "tests/ray_tracer/shapes_support.hpp"

namespace tuberia::tracer::shapes_test {
namespace {

/// Both in one place at the seam, where u is 0 and 1.
double apart(double a, double b) { return std::abs((a - b) - std::round(a - b)); }

/// At every vertex, a hair inside the rims; a sphere's poles and a cone's tip, where each triangle has a u of its own, are left out.
void compare(const Shape& shape, const Mesh& mesh, double tolerance = 5e-6) {
  REQUIRE(!mesh.positions.empty());
  int compared = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::dvec3 normal(mesh.normals[i]), vertex = (1 - 1e-6) * glm::dvec3(mesh.positions[i]);
    if (glm::length(mesh.tangents[i]) < 1e-6f) continue;
    const Ray ray{.origin = vertex + 0.3 * normal, .direction = -normal};
    const std::optional<ShapeHit> hit = shape.intersect(ray);
    INFO(mesh.name << ", vertex " << i << " at " << vertex.x << ' ' << vertex.y << ' ' << vertex.z);
    REQUIRE(hit);
    const SurfacePoint point = shape.surface(ray, *hit);
    CHECK(glm::length(point.position - vertex) < tolerance);
    CHECK(glm::length(point.normal - normal) < tolerance);
    CHECK(glm::length(point.tangent - glm::dvec3(mesh.tangents[i])) < 10 * tolerance);
    CHECK(glm::length(point.bitangent - glm::dvec3(mesh.bitangents[i])) < 10 * tolerance);
    CHECK(apart(point.texcoord.x, static_cast<double>(mesh.texcoords[i].x)) < tolerance);
    CHECK(apart(point.texcoord.y, static_cast<double>(mesh.texcoords[i].y)) < tolerance);
    CHECK(point.texcoord.x >= 0);
    CHECK(point.texcoord.x <= 1);
    ++compared;
  }
  CHECK(compared > 0);
}

std::vector<glm::dvec4> box_planes(const glm::dvec3& half) {
  return {{1, 0, 0, -half.x}, {-1, 0, 0, -half.x}, {0, 1, 0, -half.y}, {0, -1, 0, -half.y}, {0, 0, 1, -half.z}, {0, 0, -1, -half.z}};
}

}  // namespace

TEST_CASE("shapes: exact shapes have the normals, tangents and texture coordinates of their meshes", "[ray_tracer][A42]") {
  compare(Rectangle(3, 1.5), *plane_mesh({.width = 3, .depth = 1.5, .columns = 4, .rows = 3}));
  compare(Disc(1.5), *disc_mesh({.radius = 1.5, .slices = 24, .rings = 4}));
  compare(Cuboid({1, 2, 3}), *box_mesh({.width = 1, .height = 2, .depth = 3, .segments = 3}));
  compare(Sphere(1.5), *sphere_mesh({.radius = 1.5}));
  compare(Cylinder(0.8, 3), *cylinder_mesh({.radius = 0.8, .height = 3, .stacks = 4}));
  compare(Cylinder(0.8, 3, false), *cylinder_mesh({.radius = 0.8, .height = 3, .stacks = 4, .caps = false}));
  compare(Cone(0.8, 3), *cone_mesh({.radius = 0.8, .height = 3, .stacks = 4}));
  compare(Cone(0.8, 3, false), *cone_mesh({.radius = 0.8, .height = 3, .stacks = 4, .caps = false}));
  compare(Torus(1.3, 0.4), *torus_mesh({.radius = 1.3, .tube_radius = 0.4}));
  // Boxes and rectangles by their planes and corners.
  compare(**Polyhedron::create(box_planes({0.5, 1, 1.5})), *box_mesh({.width = 1, .height = 2, .depth = 3, .segments = 3}));
  const std::vector<glm::dvec3> corners{{-1.5, 0, 0.75}, {1.5, 0, 0.75}, {1.5, 0, -0.75}, {-1.5, 0, -0.75}};
  compare(**Polygon::create(corners), *plane_mesh({.width = 3, .depth = 1.5, .columns = 4, .rows = 3}));
}

TEST_CASE("shapes: tangents are what one unit of the texture coordinates moves the point", "[ray_tracer][A42]") {
  const std::vector<std::shared_ptr<const Shape>> shapes{std::make_shared<Sphere>(1.2), std::make_shared<Torus>(), std::make_shared<Cone>(),
                                                         std::make_shared<Cylinder>(), std::make_shared<Cuboid>(),
                                                         *Polyhedron::create(std::vector<glm::dvec4>{{1, 1, 1, -1}, {-1, 0.2, 0, -1}, {0, -1, 0.3, -1}, {0, 0, -1, -1}}),
                                                         std::make_shared<InfinitePlane>()};
  Random random(11);
  for (const std::shared_ptr<const Shape>& shape : shapes) {
    int compared = 0;
    for (int i = 0; i < 500; ++i) {
      const glm::dvec3 eye = in_box(random, 4);
      const auto at = [&](const glm::dvec3& target) -> std::optional<SurfacePoint> {
        const Ray ray{.origin = eye, .direction = target - eye};
        const std::optional<ShapeHit> hit = shape->intersect(ray);
        if (!hit) return std::nullopt;
        return shape->surface(ray, *hit);
      };
      const glm::dvec3 target = in_box(random, 1);
      const std::optional<SurfacePoint> here = at(target), there = at(target + 1e-6 * unit_vector(random));
      if (!here || !there || glm::length(here->normal - there->normal) > 1e-3 || glm::length(here->position - there->position) > 1e-5) continue;
      const glm::dvec2 moved = there->texcoord - here->texcoord;
      if (glm::length(moved) > 0.1) continue;  // across the seam
      const glm::dvec3 expected = moved.x * here->tangent + moved.y * here->bitangent;
      CHECK(glm::length(there->position - here->position - expected) < 1e-9 + 1e-3 * glm::length(expected));
      CHECK(glm::dot(glm::cross(here->bitangent, here->tangent), here->normal) >= 0);  // the image is not mirrored
      ++compared;
    }
    CHECK(compared > 50);
  }
}

TEST_CASE("shapes: a traced tessellation tends to the exact shape", "[ray_tracer][A42][B51]") {
  const glm::dmat4 matrix = scaled(2, {0.3, -1, 0.5}) * turned(0.7, {1, 2, -1});
  Geometry exact, fine;
  exact.add_shape(std::make_shared<Torus>(), matrix, 5);
  fine.add_mesh(*torus_mesh({.slices = 128, .stacks = 64}), matrix, 6);
  CHECK(exact.part_of(0) == 5);
  CHECK(fine.part_of(77) == 6);
  CHECK(fine.is_convex(3));
  CHECK(!exact.is_convex(0));
  Random random(3);
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    const glm::dvec3 eye = in_box(random, 8), target = in_box(random, 2);
    const Ray ray{.origin = eye, .direction = glm::normalize(target - eye)};
    const Hit a = nearest_hit(exact, ray), b = nearest_hit(fine, ray);
    if (!a || !b) continue;
    const SurfacePoint p = exact.surface(ray, a), q = fine.surface(ray, b);
    if (glm::dot(p.normal, ray.direction) > -0.3 || apart(p.texcoord.x, q.texcoord.x) > 0.1) continue;
    CHECK(glm::length(p.position - q.position) < 0.02);
    CHECK(glm::length(p.normal - q.normal) < 0.02);
    CHECK(glm::length(p.tangent - q.tangent) < 0.3);
    CHECK(glm::length(p.bitangent - q.bitangent) < 0.3);
    CHECK(apart(p.texcoord.x, q.texcoord.x) + apart(p.texcoord.y, q.texcoord.y) < 0.01);
    CHECK(glm::dot(q.geometric_normal, q.normal) > 0.99);
    ++compared;
  }
  CHECK(compared > 100);
}

TEST_CASE("shapes: what triangles know at a point", "[ray_tracer][A42]") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
  mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}};
  mesh.colours = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
  mesh.indices = {0, 1, 2};
  const Ray ray{.origin = {0.5, 0.75, 1}, .direction = {0, 0, -1}};
  Geometry geometry;
  geometry.add_mesh(mesh, glm::dmat4(1), 0);
  SurfacePoint point = geometry.surface(ray, nearest_hit(geometry, ray));
  CHECK(glm::length(point.tangent - glm::dvec3(2, 0, 0)) < 1e-15);  // test vector 15.12
  CHECK(glm::length(point.bitangent - glm::dvec3(0, 3, 0)) < 1e-15);
  CHECK(glm::length(point.colour - glm::dvec3(0.5, 0.25, 0.25)) < 1e-15);
  CHECK(glm::length(point.texcoord - glm::dvec2(0.25, 0.25)) < 1e-15);
  CHECK(point.normal == glm::dvec3(0, 0, 1));
  CHECK(point.magnitude == 3);

  // Normals at the vertices, or of the facet. A mirror leaves the outside outside.
  mesh.normals = {{0, 0, 1}, {0.6f, 0, 0.8f}, {0, 0, 1}};
  const glm::dmat4 mirror(glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(1, 0, 0, 1));
  for (const bool facets : {false, true}) {
    Geometry mirrored;
    mirrored.add_mesh(mesh, mirror, 0, facets);
    point = mirrored.surface(ray, nearest_hit(mirrored, ray));
    CHECK(point.geometric_normal == glm::dvec3(0, 0, 1));
    const glm::dvec3 smooth = glm::normalize(0.5 * glm::dvec3(0, 0, 1) + 0.25 * glm::normalize(glm::dvec3(-0.6, 0, 0.8)) + 0.25 * glm::dvec3(0, 0, 1));
    CHECK(glm::length(point.normal - (facets ? glm::dvec3(0, 0, 1) : smooth)) < 1e-7);
  }

  // Without texture coordinates, or with ones that have no area: some tangents all the same.
  mesh.texcoords = {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}};
  Geometry plain;
  plain.add_mesh(mesh, glm::dmat4(1), 0);
  point = plain.surface(ray, nearest_hit(plain, ray));
  CHECK(std::abs(glm::dot(point.tangent, point.normal)) + std::abs(glm::dot(point.bitangent, point.normal)) < 1e-15);
  CHECK(glm::length(glm::cross(point.bitangent, point.tangent) - point.normal) < 1e-15);
}

TEST_CASE("shapes: normals of stretched and mirrored shapes stay across the surface and outwards", "[ray_tracer][A42]") {
  Random random(8);
  for (int i = 0; i < 300; ++i) {
    glm::dmat4 matrix = turned(uniform(random, 0, 6), unit_vector(random)) * turned(uniform(random, 0, 6), unit_vector(random));
    for (int column = 0; column < 3; ++column) matrix[column] *= (random.below(2) == 0 ? 1 : -1) * std::pow(10, uniform(random, -1, 1));
    matrix[3] = glm::dvec4(in_box(random, 5), 1);
    Geometry geometry;
    geometry.add_shape(std::make_shared<Sphere>(), matrix, 0);
    const glm::dvec3 centre(matrix[3]), target = centre + 0.3 * glm::dmat3(matrix) * unit_vector(random), eye = in_box(random, 30);
    const Ray ray{.origin = eye, .direction = glm::normalize(target - eye)};
    const Hit hit = nearest_hit(geometry, ray);
    REQUIRE(hit);
    const SurfacePoint point = geometry.surface(ray, hit);
    CHECK(glm::dot(point.normal, point.position - centre) > 0);
    CHECK(std::abs(glm::dot(point.normal, glm::normalize(point.tangent))) < 1e-12);
    CHECK(std::abs(glm::dot(point.normal, glm::normalize(point.bitangent))) < 1e-12);
    CHECK(glm::length(ray.at(hit.t) - point.position) < 1e-12 * 60);
    const Box box = geometry.bounds(0);
    for (int axis = 0; axis < 3; ++axis) CHECK((point.position[axis] >= box.lower[axis] && point.position[axis] <= box.upper[axis]));
  }
}

}  // namespace tuberia::tracer::shapes_test
