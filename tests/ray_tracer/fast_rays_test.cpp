// Rays that nothing must be lost for, and rays that are none.

#include <catch2/catch.hpp>

#include <algorithm>
#include <ctime>

#include "tests/ray_tracer/fast_support.hpp"

namespace tuberia::tracer::fast_test {
namespace {

/// From within a closed net to points of its edges, every fourth to a vertex. 16 rays come from each eye; of every second eye's they
/// go to places of one edge that lie close together, so that they make a bundle.
std::vector<FastRay> rays_to_edges(const Mesh& net, int count, float scale, const glm::vec3& position, std::uint64_t seed) {
  Random random(seed);
  std::vector<FastRay> rays;
  for (int i = 0; i < count; i += 16) {
    const glm::vec3 eye = in_box(random, 0.25) * scale + position;
    const bool is_bundle = i % 32 == 0;
    auto triangle = static_cast<std::size_t>(random.below(net.triangle_count()));
    auto corner = static_cast<std::size_t>(random.below(3));
    const double begin = uniform(random, 0, 0.95);
    for (int j = 0; j < 16; ++j) {
      const glm::vec3 &a = net.positions[net.indices[3 * triangle + corner]], &b = net.positions[net.indices[3 * triangle + (corner + 1) % 3]];
      const float along = is_bundle ? uniform(random, begin, begin + 0.05) : j % 4 == 0 ? 0 : uniform(random, 0, 1);
      rays.push_back({.origin = eye, .direction = a + along * (b - a) - eye});
      if (is_bundle) continue;
      triangle = static_cast<std::size_t>(random.below(net.triangle_count()));
      corner = static_cast<std::size_t>(random.below(3));
    }
  }
  return rays;
}

struct Losses {
  int alone = 0, together = 0;
  int differing = 0;  // rays that meet one thing alone and another in their bundle
  bool operator==(const Losses&) const = default;
};

Losses losses(const FastTriangles& triangles, const std::vector<FastRay>& rays) {
  std::vector<FastHit> hits(rays.size());
  triangles.nearest(rays, hits);
  Losses lost;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const FastHit alone = triangles.nearest(rays[i]);
    lost.alone += alone ? 0 : 1;
    lost.together += hits[i] ? 0 : 1;
    lost.differing += alone == hits[i] ? 0 : 1;
  }
  return lost;
}

std::vector<FastRay> unsound_rays() {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinite = std::numeric_limits<float>::infinity();
  std::vector<FastRay> rays;
  for (int number = 0; number < 8; ++number)
    for (const float bad : {kNan, kInfinite, -kInfinite}) {
      FastRay ray{.origin = {0.1f, 0.2f, 3}, .direction = {0.1f, 0.1f, -1}};
      float* const numbers[] = {&ray.origin.x, &ray.origin.y, &ray.origin.z, &ray.t_min, &ray.direction.x, &ray.direction.y, &ray.direction.z, &ray.t_max};
      *numbers[number] = bad;
      if (number < 7 || bad != kInfinite) rays.push_back(ray);
    }
  rays.push_back({.origin = {0, 0, 3}, .direction = {0, 0, 0}});
  rays.push_back({.origin = {0, 0, 3}, .t_min = 5, .direction = {0, 0, -1}, .t_max = 1});
  rays.push_back({.origin = {0, 0, 3}, .t_min = 2, .direction = {0, 0, -1}, .t_max = 2});
  return rays;
}

/// Processor time of this thread, least of several runs.
double seconds_for(const FastTriangles& triangles, const std::vector<FastRay>& rays, bool together) {
  const auto processor_time = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  std::vector<FastHit> hits(rays.size());
  double least = 1e9;
  for (int run = 0; run < 9; ++run) {
    const double start = processor_time();
    if (together)
      triangles.nearest(rays, hits);
    else
      for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = triangles.nearest(rays[i]);
    least = std::min(least, processor_time() - start);
  }
  return least;
}

}  // namespace

TEST_CASE("fast: no ray passes between triangles that share an edge or a vertex", "[ray_tracer][fast][Y1]") {
  const Mesh net = closed_net(24, 3, 20);
  const auto check = [&](float scale, const glm::vec3& position, int rays) {
    INFO("scale " << scale << ", at " << position.x);
    const Mesh there = placed(net, scale, position);
    FastTriangles triangles = triangles_of(there);
    const std::vector<FastRay> to_edges = rays_to_edges(there, rays, scale, position, 21);
    for (const std::string_view set : FastTriangles::instruction_sets()) {
      INFO(set);
      triangles.use_instruction_set(set);
      CHECK(losses(triangles, to_edges) == Losses{});
    }
  };
  check(1, glm::vec3(0), 1'000'000);
  check(4, {148376, 1234, -223423}, 1'000'000);
  for (const float scale : {1e-3f, 1e3f, 1e6f}) check(scale, glm::vec3(0), 200'000);
}

TEST_CASE("fast: rays along the axes meet a net of whole numbers at its edges and vertices", "[ray_tracer][fast][Y1]") {
  Mesh net;
  for (int z = 0; z <= 8; ++z)
    for (int x = 0; x <= 8; ++x) net.positions.emplace_back(x, 0, z);
  for (std::uint32_t z = 0; z < 8; ++z)
    for (std::uint32_t x = 0; x < 8; ++x) {
      const std::uint32_t a = 9 * z + x;
      for (const std::uint32_t vertex : {a, a + 9, a + 10, a, a + 10, a + 1}) net.indices.push_back(vertex);
    }
  for (int turn = 0; turn < 3; ++turn) {
    std::vector<FastRay> rays;
    for (int z = 0; z <= 32; ++z)
      for (int x = 0; x <= 32; ++x)
        for (const float side : {1.0f, -1.0f}) {
          glm::vec3 origin(0), direction(0);
          origin[turn] = 0.25f * static_cast<float>(x), origin[(turn + 1) % 3] = 2 * side, origin[(turn + 2) % 3] = 0.25f * static_cast<float>(z);
          direction[(turn + 1) % 3] = -side;
          rays.push_back({.origin = origin, .direction = direction});
        }
    Mesh turned = net;
    for (glm::vec3& p : turned.positions) {
      const glm::vec3 before = p;
      p[turn] = before.x, p[(turn + 1) % 3] = before.y, p[(turn + 2) % 3] = before.z;
    }
    FastTriangles triangles = triangles_of(turned);
    for (const std::string_view set : FastTriangles::instruction_sets()) {
      triangles.use_instruction_set(set);
      CHECK(losses(triangles, rays) == Losses{});
      for (const FastRay& ray : rays) REQUIRE(triangles.nearest(ray).t == 2);
    }
  }
}

TEST_CASE("fast: rays that are none meet nothing", "[ray_tracer][fast][Y3]") {
  FastTriangles triangles = triangles_of(closed_net(40, 0.1, 22));
  const std::vector<FastRay> rays = unsound_rays();
  // Among sound ones, too, which they must not harm.
  std::vector<FastRay> mixed = camera_rays({0.1f, 0.2f, 3}, 64, 64);
  std::vector<FastHit> expected(mixed.size());
  for (std::size_t i = 0; i < mixed.size(); ++i) expected[i] = triangles.nearest(mixed[i]);
  for (std::size_t i = 0; i < rays.size(); ++i) mixed[37 * i] = rays[i], expected[37 * i] = {};
  CHECK(std::count_if(expected.begin(), expected.end(), [](const FastHit& hit) { return bool(hit); }) > 300);
  CHECK(differences(triangles, rays, std::vector<FastHit>(rays.size())) == 0);
  CHECK(differences(triangles, mixed, expected) == 0);
}

TEST_CASE("fast: rays that are none, or come from nowhere near, cost no more than others", "[ray_tracer][fast][Y3]") {
  const FastTriangles triangles = triangles_of(closed_net(160, 0.1, 23));
  const std::vector<FastRay> normal = camera_rays({0, 0.5f, 2}, 128, 128);
  const std::vector<FastRay> kinds = unsound_rays();
  std::vector<FastRay> unsound, far(normal);
  for (std::size_t i = 0; i < normal.size(); ++i) unsound.push_back(kinds[i % kinds.size()]);
  for (FastRay& ray : far) ray.origin *= 1e30f, ray.direction = -ray.origin;
  for (const bool together : {false, true}) {
    INFO("together " << together);
    const double usual = seconds_for(triangles, normal, false);
    CHECK(seconds_for(triangles, unsound, together) < 2.5 * usual);
    CHECK(seconds_for(triangles, far, together) < 2.5 * usual);
  }
}

}  // namespace tuberia::tracer::fast_test
