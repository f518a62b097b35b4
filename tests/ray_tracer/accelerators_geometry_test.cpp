// The accelerators among real shapes and triangles.

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <vector>

#include "math/transforms.hpp"
#include "reference/ray_tracer/accelerators/accelerator.hpp"
#include "reference/ray_tracer/geometry.hpp"
#include "reference/ray_tracer/shapes/cuboid.hpp"
#include "reference/ray_tracer/shapes/flat_shapes.hpp"
#include "reference/ray_tracer/shapes/polygon.hpp"
#include "reference/ray_tracer/shapes/quadric.hpp"
#include "reference/ray_tracer/shapes/round_shapes.hpp"
#include "reference/ray_tracer/shapes/sphere.hpp"
#include "reference/ray_tracer/shapes/torus.hpp"
#include "tests/ray_tracer/accelerators_scenes.hpp"

using namespace tuberia;
using namespace tuberia::tracer;
using namespace tuberia::tracer::test;

namespace {

constexpr AcceleratorKind kAllAccelerators[] = {AcceleratorKind::bounding_spheres, AcceleratorKind::bvh, AcceleratorKind::grid, AcceleratorKind::octree};

glm::dmat4 placed(double size, const glm::dvec3& at) { return {{size, 0, 0, 0}, {0, size, 0, 0}, {0, 0, size, 0}, glm::dvec4(at, 1)}; }

/// A net of 2 n^2 triangles over a square, with hills of this height; flat if it is 0.
Mesh hills(int n, float height, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const auto at = [n](int i) { return 2 * static_cast<float>(i) / static_cast<float>(n) - 1; };
      mesh.positions.push_back({at(x), height * random.between(-1, 1), at(y)});
    }
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const auto a = static_cast<std::uint32_t>(y * (n + 1) + x), b = a + 1, c = a + static_cast<std::uint32_t>(n) + 1, d = c + 1;
      for (const std::uint32_t index : {a, c, b, b, c, d}) mesh.indices.push_back(index);
    }
  return mesh;
}

/// One of each kind, no larger than about 2 units.
std::vector<std::shared_ptr<const Shape>> shapes_of_all_kinds() {
  const std::vector<glm::dvec3> bent{{-1, 0, -1}, {1, 0, -1}, {1, 9e-7, 1}, {0, 0, 0.2}, {-1, 0, 1}};  // plane by as much as is asked for
  const glm::dmat4 saddle{{1, 0, 0, 0}, {0, 0, 0, 0.5}, {0, 0, -1, 0}, {0, 0.5, 0, 0}};
  return {std::make_shared<Sphere>(), std::make_shared<Cuboid>(glm::dvec3(1, 0.5, 2)), std::make_shared<Disc>(), std::make_shared<Cylinder>(),
          std::make_shared<Cone>(0.5, 2, false), std::make_shared<Torus>(), *Polygon::create(bent), *Quadric::create(saddle, glm::dvec3(-1), glm::dvec3(1))};
}

/// All of those in many places, on hills, over an endless plane.
Geometry many_shapes() {
  Geometry geometry;
  Random random(31);
  geometry.add_mesh(hills(20, 0.2f, 30), placed(1, {0, -0.5, 0}), 0);
  geometry.add_shape(std::make_shared<InfinitePlane>(), placed(1, {0, -0.8, 0}), 1);
  const auto kinds = shapes_of_all_kinds();
  for (std::size_t i = 0; i < 300; ++i)
    geometry.add_shape(kinds[i % kinds.size()], placed(0.1, random_in_cube(random)) * glm::dmat4(rotation({1, 0.5, 0.2}, random.between(0, 6))), 2);
  return geometry;
}

/// At corners, edges and insides of the triangles and elsewhere, and in the planes of the net.
std::vector<Ray> rays_at(const Mesh& mesh, const glm::dmat4& world_from_object, int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Ray> rays;
  const auto corner = [&](std::size_t index) { return glm::dvec3(world_from_object * glm::dvec4(mesh.positions[mesh.indices[index]], 1)); };
  const double size = glm::length(glm::dvec3(world_from_object[0]));
  for (int i = 0; i < count; ++i) {
    const auto first = static_cast<std::size_t>(3 * random.below(mesh.triangle_count()));
    glm::dvec3 weights(1, 0, 0);
    if (i % 3 == 1) weights = {random.between(0, 1), 0, 0}, weights.y = 1 - weights.x;
    if (i % 3 == 2) weights = glm::abs(random_in_cube(random)), weights /= weights.x + weights.y + weights.z;
    const glm::dvec3 target = weights.x * corner(first) + weights.y * corner(first + 1) + weights.z * corner(first + 2);
    Ray ray{.origin = target + 3 * size * random_in_cube(random)};
    if (i % 5 == 3) ray.origin.y = target.y;
    if (i % 5 == 4) ray.origin = target + size * glm::dvec3(0, 1, 0);
    ray.direction = glm::normalize(target - ray.origin);
    rays.push_back(ray);
  }
  return rays;
}

int differences(const Items& items, std::span<const Ray> rays) {
  Workers workers;
  Traversal traversal;
  const auto none = make_accelerator(AcceleratorKind::none, items, workers);
  int different = 0;
  for (const AcceleratorKind kind : kAllAccelerators) {
    const auto accelerator = make_accelerator(kind, items, workers);
    for (const Ray& ray : rays) {
      const Hit expected = none->nearest(ray, traversal);
      different += accelerator->nearest(ray, traversal) != expected;
      different += accelerator->any(ray, traversal) != static_cast<bool>(expected);
    }
  }
  return different;
}

}  // namespace

TEST_CASE("accelerators: triangles, aimed at their corners, edges and planes, at all scales", "[accelerators][C40][B67]") {
  for (const float height : {0.3f, 0.0f})
    for (const double size : {1e-3, 1.0, 1e6})
      for (const glm::dvec3& at : {glm::dvec3(0), glm::dvec3(148376, 1234, -223423), glm::dvec3(-1e6, 1e6, 1e6)}) {
        INFO("hills of " << height << ", size " << size << ", at " << at.x);
        Geometry geometry;
        const Mesh mesh = hills(16, height, 32);
        geometry.add_mesh(mesh, placed(size, at), 0);
        CHECK(differences(geometry, rays_at(mesh, placed(size, at), 600, 33)) == 0);
      }
}

TEST_CASE("accelerators: shapes of all kinds and an endless plane", "[accelerators][C40]") {
  const Geometry geometry = many_shapes();
  CHECK(differences(geometry, awkward_rays({"", {}, {0, 0, 0}, 1}, 3000, 34)) == 0);
}

TEST_CASE("accelerators: shapes are met in their boxes and spheres", "[accelerators][B64]") {
  const Geometry geometry = many_shapes();
  Random random(40);
  int met = 0;
  for (int i = 0; i < 300'000; ++i) {
    const std::int64_t item = random.below(geometry.count());
    const Box box = geometry.bounds(item);
    const bool is_bounded = std::isfinite(box.size().x);
    Ray ray{.origin = 3.0 * random_in_cube(random)};
    ray.direction = glm::normalize(box.lower + 0.5 * (random_in_cube(random) + 1.0) * box.size() - ray.origin);
    Hit hit;
    if (!is_bounded || !geometry.intersect(item, PreparedRay(ray), hit)) continue;
    ++met;
    const glm::dvec3 at = ray.at(hit.t), outside = glm::max(glm::max(box.lower - at, at - box.upper), glm::dvec3(0));
    const BoundingSphere sphere = geometry.bounding_sphere(item);
    // What the accelerators allow for.
    constexpr double kSlack = 0x1p-42 * 3;
    if (glm::length(outside) > kSlack) FAIL("item " << item << " is met " << glm::length(outside) << " outside its box");
    if (glm::length(at - sphere.centre) > sphere.radius + kSlack) FAIL("item " << item << " is met outside its sphere");
  }
  CHECK(met > 50'000);
}

TEST_CASE("accelerators: a triangle's sphere is around its centroid and reaches its farthest corner", "[accelerators][B64]") {
  Geometry geometry;
  geometry.add_mesh(hills(12, 0.7f, 35), placed(3, {7, -5, 2}), 0);
  for (std::int64_t item = 0; item < geometry.count(); ++item) {
    const auto corners = *geometry.triangle(item);
    const BoundingSphere sphere = geometry.bounding_sphere(item);
    CHECK(glm::length(sphere.centre - (corners[0] + corners[1] + corners[2]) / 3.0) < 1e-14);
    double farthest = 0;
    for (const glm::dvec3& corner : corners) farthest = std::max(farthest, glm::length(corner - sphere.centre));
    CHECK(sphere.radius == farthest);
  }
}

TEST_CASE("accelerators: shapes are in their bounding spheres, however they are placed", "[accelerators][B64]") {
  const glm::dmat4 sheared{{2, 0.5, 0, 0}, {1, -1, 0.3, 0}, {0, 0.2, 4, 0}, {3, 2, 1, 1}};
  Geometry geometry;
  geometry.add_shape(std::make_shared<Sphere>(0.5, glm::dvec3(1, 2, 3)), placed(3, {4, 5, 6}) * glm::dmat4(rotation({1, 2, 3}, 0.7)), 0);
  geometry.add_shape(std::make_shared<Sphere>(0.5, glm::dvec3(1, 2, 3)), sheared, 0);
  geometry.add_shape(std::make_shared<Cuboid>(glm::dvec3(1, 2, 3)), sheared, 0);
  // A sphere that is still one is its own bounding sphere.
  CHECK(geometry.bounding_sphere(0).radius == Approx(1.5).epsilon(1e-6));

  Random random(36);
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray{.origin = 30.0 * random_in_cube(random), .direction = random_direction(random)};
    Ray aimed = ray;
    const auto item = static_cast<std::int64_t>(i % 3);
    aimed.direction = glm::normalize(geometry.bounding_sphere(item).centre + random_in_cube(random) - ray.origin);
    Hit hit;
    if (!geometry.intersect(item, PreparedRay(aimed), hit)) continue;
    ++met;
    const BoundingSphere sphere = geometry.bounding_sphere(item);
    if (glm::length(aimed.at(hit.t) - sphere.centre) > sphere.radius * (1 + 1e-12)) FAIL("item " << item << " is met outside its sphere");
  }
  CHECK(met > 10000);
}

TEST_CASE("accelerators: 10,584 spheres, the same picture by all five", "[accelerators][B67]") {
  Geometry geometry;
  Random random(37);
  const auto ball = std::make_shared<Sphere>();
  for (int i = 0; i < 10'584; ++i) geometry.add_shape(ball, placed(0.02, random_in_cube(random)), 0);
  constexpr int kPixels = 24;
  std::vector<Ray> rays;
  for (int y = 0; y < kPixels; ++y)
    for (int x = 0; x < kPixels; ++x) {
      const glm::dvec3 towards((x + 0.5) / kPixels - 0.5, 0.5 - (y + 0.5) / kPixels, -1);
      rays.push_back({.origin = {0, 0, 3}, .direction = glm::normalize(towards)});
    }
  CHECK(differences(geometry, rays) == 0);

  // What the notes had days for: here as tests of each ray.
  Workers workers;
  for (const AcceleratorKind kind : kAllAccelerators) {
    const auto accelerator = make_accelerator(kind, geometry, workers);
    Traversal traversal;
    for (const Ray& ray : rays) accelerator->nearest(ray, traversal);
    INFO(name_of(kind) << ": " << static_cast<double>(traversal.work.item_tests) / static_cast<double>(rays.size()) << " tests of a ray");
    CHECK(traversal.work.item_tests * 100 < geometry.count() * static_cast<std::int64_t>(rays.size()));
  }
}
