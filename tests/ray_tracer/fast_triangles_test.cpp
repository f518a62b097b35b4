#include <catch2/catch.hpp>

#include "tests/ray_tracer/fast_support.hpp"

namespace tuberia::tracer::fast_test {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

std::vector<FastHit> expected_by_all(const Mesh& mesh, const std::vector<FastRay>& rays) {
  const InDoubles doubles(mesh);
  std::vector<FastHit> hits;
  for (const FastRay& ray : rays) hits.push_back(doubles.nearest(ray));
  return hits;
}

std::vector<FastHit> expected_by_bvh(const Mesh& mesh, const std::vector<FastRay>& rays) {
  const InDoubles doubles(mesh);
  Workers workers(2);
  const auto accelerator = make_accelerator(AcceleratorKind::bvh, doubles.geometry(), workers);
  Traversal traversal;
  std::vector<FastHit> hits;
  for (const FastRay& ray : rays) hits.push_back(in_floats(accelerator->nearest(in_doubles(ray), traversal)));
  return hits;
}

int count_hits(const std::vector<FastHit>& hits) {
  int count = 0;
  for (const FastHit& hit : hits) count += hit ? 1 : 0;
  return count;
}

/// Compared with every triangle asked in doubles. Returns how many met something.
int check_against_all(const Mesh& mesh, const std::vector<FastRay>& rays) {
  FastTriangles triangles = triangles_of(mesh);
  const std::vector<FastHit> expected = expected_by_all(mesh, rays);
  CHECK(differences(triangles, rays, expected) == 0);
  return count_hits(expected);
}

/// Both triangles and rays moved and scaled.
std::vector<FastRay> placed_rays(std::vector<FastRay> rays, float scale, const glm::vec3& position) {
  for (FastRay& ray : rays) ray.origin = ray.origin * scale + position;
  return rays;
}

}  // namespace

TEST_CASE("fast: the hits of the tracer in doubles to the last bit, alone and in bundles, on every instruction set", "[ray_tracer][fast]") {
  const Mesh net = closed_net(160, 0.2, 1);
  FastTriangles triangles = triangles_of(net);
  for (const glm::vec3& eye : {glm::vec3(0, 0, 3), glm::vec3(-2, 1, 1.5), glm::vec3(0.1, -0.2, 0.3), glm::vec3(9, 9, -9)}) {
    const std::vector<FastRay> rays = camera_rays(eye, 128, 96);
    const std::vector<FastHit> expected = expected_by_bvh(net, rays);
    CHECK(count_hits(expected) > 100);
    CHECK(differences(triangles, rays, expected) == 0);
  }
  const std::vector<FastRay> rays = random_rays(20'000, 1.5, 2);
  const std::vector<FastHit> expected = expected_by_bvh(net, rays);
  CHECK(count_hits(expected) > 5000);
  CHECK(differences(triangles, rays, expected) == 0);
}

TEST_CASE("fast: no triangle is overlooked at any scale, flat or long", "[ray_tracer][fast]") {
  const Mesh mesh = soup(700, 3);
  std::vector<FastRay> rays = camera_rays({1, 2, 3}, 32, 32);
  for (const FastRay& ray : random_rays(1500, 1.2, 4)) rays.push_back(ray);
  for (const float scale : {1e-12f, 1e-3f, 1.0f, 1e6f, 1e12f}) {
    INFO("scale " << scale);
    CHECK(check_against_all(placed(mesh, scale), placed_rays(rays, scale, glm::vec3(0))) > 1000);
  }
  const glm::vec3 away(148376, 1234, -223423);
  CHECK(check_against_all(placed(mesh, 100, away), placed_rays(rays, 100, away)) > 1000);
}

TEST_CASE("fast: directions of any length, origins far away", "[ray_tracer][fast]") {
  const Mesh mesh = soup(500, 5);
  Random random(6);
  for (const double length : {1e-37, 1e-20, 1e-4, 1e4, 1e20, 1e37}) {
    INFO("length " << length);
    std::vector<FastRay> rays = random_rays(200, 1.2, 7);
    for (FastRay& ray : rays) ray.direction *= static_cast<float>(length);
    CHECK(check_against_all(mesh, rays) > 50);
  }
  for (const double distance : {10.0, 1e2, 1e4, 1e6, 1e7}) {
    INFO("distance " << distance);
    std::vector<FastRay> rays;
    for (int i = 0; i < 300; ++i) {
      const glm::dvec3 from = distance * glm::normalize(glm::dvec3(any_direction(random)));
      rays.push_back({.origin = glm::vec3(from), .direction = glm::vec3(glm::dvec3(in_box(random, 0.9)) - from)});
    }
    CHECK(check_against_all(mesh, rays) > 30);
    // Where the scene is far from the world's origin as well.
    const glm::vec3 away(148376, 1234, -223423);
    CHECK(check_against_all(placed(mesh, 20, away), placed_rays(rays, 20, away)) > 20);
  }
}

TEST_CASE("fast: triangles are met between t_min and t_max, behind the origin, too", "[ray_tracer][fast]") {
  const Mesh mesh = soup(500, 8);
  Random random(9);
  std::vector<FastRay> rays;
  for (const FastRay& whole : random_rays(1000, 1, 10)) {
    FastRay ray = whole;
    ray.t_min = uniform(random, -2, 1);
    ray.t_max = ray.t_min + uniform(random, 0, 1);
    rays.push_back(ray);
    ray.t_min = -3, ray.t_max = -0.1f;
    rays.push_back(ray);
  }
  std::vector<FastRay> bundles = camera_rays({1, 2, 2}, 32, 32);
  for (FastRay& ray : bundles) ray.t_min = uniform(random, 1.5, 3.5), ray.t_max = uniform(random, 3.5, 4);
  CHECK(check_against_all(mesh, rays) > 100);
  CHECK(check_against_all(mesh, bundles) > 100);

  // The ends themselves do not count.
  Mesh wall;
  wall.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  wall.indices = {0, 1, 2};
  const FastTriangles triangles = triangles_of(wall);
  const auto met = [&](float t_min, float t_max) { return bool(triangles.nearest({{0, 0, 2}, t_min, {0, 0, -1}, t_max})); };
  CHECK(met(1, 3));
  CHECK_FALSE(met(2, 3));
  CHECK_FALSE(met(1, 2));
  CHECK(met(std::nextafter(2.0f, 1.0f), std::nextafter(2.0f, 3.0f)));
}

TEST_CASE("fast: of triangles in one place the first is met", "[ray_tracer][fast]") {
  Mesh mesh = closed_net(12, 0.3, 11);
  const std::vector<std::uint32_t> once = mesh.indices;
  for (int copy = 0; copy < 20; ++copy) mesh.indices.insert(mesh.indices.end(), once.rbegin(), once.rend());
  CHECK(check_against_all(mesh, camera_rays({0, 1, 3}, 32, 32)) > 100);
  CHECK(check_against_all(mesh, random_rays(500, 0.5, 12)) == 500);
}

TEST_CASE("fast: lopsided and repeated triangles make no tree too deep", "[ray_tracer][fast]") {
  // Along each axis every triangle is twice as far out as the one before, so that bins of equal widths separate only a few at a time.
  Mesh mesh;
  std::vector<FastRay> rays;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = -120; i < 58; ++i) {
      const float at = std::ldexp(1.0f, i), size = 0.25f * at;
      glm::vec3 corner(0);
      corner[axis] = at;
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), {corner, corner + size * glm::vec3(1, 1, 0), corner + size * glm::vec3(0, 1, 1)});
      for (int copy = 0; copy < 12; ++copy) mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
      const glm::vec3 middle = corner + size * glm::vec3(0.25f, 0.5f, 0.25f);
      rays.push_back({.origin = middle + at * glm::vec3(0.5f, -0.5f, 0.4f), .direction = at * glm::vec3(-0.5f, 0.5f, -0.4f)});
    }
  CHECK(check_against_all(mesh, rays) > 300);
}

TEST_CASE("fast: the same tree for any number of workers", "[ray_tracer][fast]") {
  const Mesh net = closed_net(120, 0.3, 14);
  const std::vector<FastRay> rays = random_rays(5000, 1.5, 15);
  const FastTriangles one = triangles_of(net, 1), two = triangles_of(net, 2), five = triangles_of(net, 5);
  CHECK(one.facts().nodes == five.facts().nodes);
  CHECK(one.facts().blocks == two.facts().blocks);
  CHECK(one.facts().triangles == 2 * 120 * 120 - 2 * 120);  // those at the poles have no area
  int differing = 0;
  for (const FastRay& ray : rays) differing += one.nearest(ray) == two.nearest(ray) && one.nearest(ray) == five.nearest(ray) ? 0 : 1;
  CHECK(differing == 0);
}

TEST_CASE("fast: bad triangles are refused by name or never met", "[ray_tracer][fast]") {
  Workers workers(1);
  const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {NAN, 0, 0}, {kInfinite, 1, 1}, {2, 0, 0}, {1e19f, 0, 1}};
  const auto error_of = [&](std::vector<std::uint32_t> indices) { return FastTriangles::create(positions, indices, workers).error().message; };
  CHECK(error_of({0, 1, 2, 0, 1, 7}) == "index 5 is 7, but there are 7 positions");
  CHECK(error_of({0, 1, 2, 0}) == "4 indices are no whole number of triangles");

  const std::vector<std::uint32_t> indices{0, 1, 3, 0, 1, 4, 0, 1, 5, 1, 1, 1, 0, 1, 6, 0, 1, 2};
  const FastTriangles triangles = FastTriangles::create(positions, indices, workers).value();
  CHECK(triangles.facts().triangles == 1);
  const FastHit hit = triangles.nearest({{0.25f, 0.5f, 1}, 0, {0, 0, -1}});
  CHECK(hit == FastHit{.t = 1, .triangle = 5, .u = 0.25f, .v = 0.5f});

  const FastTriangles nothing = FastTriangles::create({}, {}, workers).value();
  CHECK_FALSE(nothing.nearest({}));
  std::vector<FastRay> rays(20);
  std::vector<FastHit> hits(20, hit);
  nothing.nearest(rays, hits);
  CHECK(count_hits(hits) == 0);
}

}  // namespace tuberia::tracer::fast_test
