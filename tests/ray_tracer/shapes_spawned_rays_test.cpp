#include <catch2/catch.hpp>

#include "reference/ray_tracer/shapes/cuboid.hpp"
#include "reference/ray_tracer/shapes/flat_shapes.hpp"
#include "reference/ray_tracer/shapes/polygon.hpp"
#include "reference/ray_tracer/shapes/polyhedron.hpp"
#include "reference/ray_tracer/shapes/quadric.hpp"
#include "reference/ray_tracer/shapes/round_shapes.hpp"
#include "reference/ray_tracer/shapes/sphere.hpp"
#include "tests/ray_tracer/shapes_support.hpp"

namespace tuberia::tracer::shapes_test {
namespace {

std::vector<std::shared_ptr<const Shape>> convex_shapes() {
  glm::dmat4 ellipsoid(1);
  ellipsoid[1][1] = 3, ellipsoid[0][1] = ellipsoid[1][0] = 0.4, ellipsoid[3][3] = -1;
  const std::vector<glm::dvec4> tetrahedron{{1, 1, 1, -1}, {-1, 0, 0, -0.3}, {0, -1, 0.2, -0.3}, {0, 0, -1, -0.3}};
  const std::vector<glm::dvec3> corners{{-1, 0, 1}, {1, 0.5, 1}, {1, 0.5, -1}, {-1, 0, -1}};
  return {std::make_shared<Sphere>(), std::make_shared<Sphere>(1, glm::dvec3(0.3, -1, 0.2)), std::make_shared<Cuboid>(glm::dvec3(1, 2, 1.5)),
          std::make_shared<Cylinder>(), std::make_shared<Cylinder>(1, 2, false), std::make_shared<Cone>(), std::make_shared<Cone>(1, 0.2, false),
          std::make_shared<Disc>(), std::make_shared<Rectangle>(), std::make_shared<InfinitePlane>(), *Polyhedron::create(tetrahedron),
          *Polygon::create(corners), *Quadric::create(ellipsoid, glm::dvec3(-2), glm::dvec3(2))};
}

/// Above the surface: anywhere, or grazing it by 1 to 1e-12.
glm::dvec3 outwards(Random& random, const glm::dvec3& normal) {
  const glm::dvec3 any = unit_vector(random), along = glm::normalize(any - glm::dot(any, normal) * normal);
  if (random.below(2) == 0) return glm::dot(any, normal) < 0 ? -any : any;
  return glm::normalize(along + std::pow(10, -uniform(random, 0, 12)) * normal);
}

struct Counts {
  int spawned = 0, self_hits = 0, lost_inside = 0;
};

/// Rays that start where others met the shape, to the outside; and to the inside of solid ones, from where there is a way out.
Counts spawn(const Geometry& geometry, const Placement& placement, int rays, bool is_solid, Random& random) {
  Counts counts;
  for (int i = 0; counts.spawned < rays && i < 40 * rays; ++i) {
    const glm::dvec3 eye = placement.point_to_world(in_box(random, 4)), target = placement.point_to_world(in_box(random, 1));
    const Ray ray{.origin = eye, .direction = glm::normalize(target - eye)};
    const Hit hit = nearest_hit(geometry, ray);
    if (!hit) continue;
    const SurfacePoint point = geometry.surface(ray, hit);
    const double offset = safe_offset(point);
    for (int k = 0; k < 4; ++k) {
      const glm::dvec3 direction = outwards(random, point.geometric_normal);
      if (!(glm::dot(direction, point.geometric_normal) > 0)) continue;
      ++counts.spawned;
      if (nearest_hit(geometry, {.origin = point.position + offset * point.geometric_normal, .direction = direction})) ++counts.self_hits;
      if (is_solid && !nearest_hit(geometry, {.origin = point.position - offset * point.geometric_normal, .direction = -point.geometric_normal}))
        ++counts.lost_inside;
    }
  }
  return counts;
}

}  // namespace

TEST_CASE("shapes: rays that start on a convex shape do not meet it again", "[ray_tracer][Y2]") {
  const std::vector<std::shared_ptr<const Shape>> shapes = convex_shapes();
  Random random(2);
  for (const double scale : kScales) {
    Counts all;
    for (const std::shared_ptr<const Shape>& shape : shapes) {
      REQUIRE(shape->is_convex());
      for (const double distance : {0.0, 3.0, 300.0}) {
        const glm::dmat4 matrix = scaled(scale, distance * scale * glm::dvec3(0.6, -0.7, 0.9)) * turned(distance, {1, 2, 3});
        Geometry geometry;
        geometry.add_shape(shape, matrix, 0);
        const std::size_t number = static_cast<std::size_t>(&shape - shapes.data());
        const bool is_solid = number == 0 || number == 1 || number == 2 || number == 3 || number == 5 || number == 10 || number == 12;
        const Counts counts = spawn(geometry, Placement(matrix), 26'000, is_solid, random);
        INFO("shape " << number << ", scale " << scale << ", distance " << distance << ", " << counts.spawned << " rays");
        CHECK(counts.spawned >= 26'000);
        CHECK(counts.self_hits == 0);
        CHECK(counts.lost_inside == 0);
        all.spawned += counts.spawned;
      }
    }
    CHECK(all.spawned >= 1'000'000);
  }
}

TEST_CASE("shapes: rays that start on the ground sphere or a triangle do not meet it again", "[ray_tracer][Y2]") {
  Random random(3);
  for (const double scale : kScales) {
    // The surface near the world's origin, the numbers that make it far from 0.
    Geometry ground;
    ground.add_shape(std::make_shared<Sphere>(1e6 * scale), scaled(1, {0, -1e6 * scale, 0}), 0);
    const Counts on_ground = spawn(ground, Placement(scaled(scale)), 40'000, true, random);
    CHECK(on_ground.spawned >= 40'000);
    CHECK(on_ground.self_hits == 0);
    CHECK(on_ground.lost_inside == 0);

    Mesh mesh;
    mesh.positions = {{-3, 0.1f, -3}, {3, 0.7f, -2}, {0.5f, -0.4f, 3}, {-1000, -1, 1000}, {1000, -1, 1000}, {0, -1, -1000}};
    mesh.indices = {0, 2, 1, 3, 4, 5};
    for (const std::size_t triangle : {0u, 1u}) {
      Mesh single = mesh;
      single.indices.assign(mesh.indices.begin() + static_cast<std::ptrdiff_t>(3 * triangle), mesh.indices.begin() + static_cast<std::ptrdiff_t>(3 * triangle + 3));
      for (const double distance : {0.0, 300.0}) {
        const glm::dmat4 matrix = scaled(scale, distance * scale * glm::dvec3(0.6, -0.7, 0.9)) * turned(distance, {1, 2, 3});
        Geometry geometry;
        geometry.add_mesh(single, matrix, 0);
        const Counts counts = spawn(geometry, Placement(matrix), 40'000, false, random);
        INFO("triangle " << triangle << ", scale " << scale << ", distance " << distance);
        CHECK(counts.spawned >= 40'000);
        CHECK(counts.self_hits == 0);
      }
    }
  }
}

}  // namespace tuberia::tracer::shapes_test
