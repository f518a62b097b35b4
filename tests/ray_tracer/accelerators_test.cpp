// Every accelerator finds what asking every item finds, to the last bit.                     [B 5.7] [C]

#include "reference/ray_tracer/accelerators/accelerator.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <span>
#include <vector>

#include "tests/ray_tracer/accelerators_scenes.hpp"

using namespace tuberia;
using namespace tuberia::tracer;
using namespace tuberia::tracer::test;

namespace {

constexpr AcceleratorKind kAccelerators[] = {AcceleratorKind::none, AcceleratorKind::bounding_spheres, AcceleratorKind::bvh, AcceleratorKind::grid,
                                             AcceleratorKind::octree};

/// [C]: for every ray every item, nothing else.
Hit asked_of_all(const Items& items, const Ray& ray) {
  Hit nearest;
  if (!is_sound(ray)) return nearest;
  const PreparedRay prepared(ray);
  for (std::int64_t i = 0; i < items.count(); ++i) items.intersect(i, prepared, nearest);
  return nearest;
}

/// How many rays an accelerator answers wrongly.
int wrong_answers(const Accelerator& accelerator, const Items& items, std::span<const Ray> rays) {
  Traversal traversal;
  int wrong = 0;
  for (const Ray& ray : rays) {
    const Hit expected = asked_of_all(items, ray);
    wrong += accelerator.nearest(ray, traversal) != expected;
    wrong += accelerator.any(ray, traversal) != static_cast<bool>(expected);
  }
  return wrong;
}

}  // namespace

TEST_CASE("accelerators: the same hits to the last bit in every scene", "[accelerators][C40][B67]") {
  Workers workers;
  for (const SimpleScene& scene : awkward_scenes()) {
    const std::vector<Ray> rays = awkward_rays(scene, 3000, 17);
    for (const AcceleratorKind kind : kAccelerators) {
      INFO(scene.name << ", " << name_of(kind));
      CHECK(wrong_answers(*make_accelerator(kind, scene.items, workers), scene.items, rays) == 0);
    }
  }
}

TEST_CASE("accelerators: without one, every ray asks every item", "[accelerators][C40]") {
  Workers workers(1);
  const SimpleScene scene = scattered("many", 100, {0, 0, 0}, 1, 2);
  const auto none = make_accelerator(AcceleratorKind::none, scene.items, workers);
  Traversal traversal;
  for (const Ray& ray : awkward_rays(scene, 50, 3)) none->nearest(ray, traversal);
  CHECK(traversal.work == TraversalWork{.rays = 50, .item_tests = 5000, .volume_tests = 0});
  CHECK(none->facts().volumes == 0);
}

TEST_CASE("accelerators: a ray that goes on meets everything in order, what is at the same place, too", "[accelerators][C40]") {
  Workers workers(1);
  for (const SimpleScene& scene : awkward_scenes()) {
    const auto none = make_accelerator(AcceleratorKind::none, scene.items, workers);
    for (const AcceleratorKind kind : kAccelerators) {
      CAPTURE(scene.name, static_cast<int>(kind));
      const auto accelerator = make_accelerator(kind, scene.items, workers);
      Traversal traversal;
      for (Ray ray : awkward_rays(scene, 20, 4)) {
        int steps = 0;
        for (Hit hit; (hit = accelerator->nearest(ray, traversal)) && steps < 40; ++steps) {
          REQUIRE(hit == none->nearest(ray, traversal));
          REQUIRE(accelerator->any(ray, traversal));
          REQUIRE((hit.t > ray.t_min || (hit.t == ray.t_min && hit.item >= ray.first_item_at_t_min)));
          ray.t_min = hit.t;
          ray.first_item_at_t_min = hit.item + 1;
        }
      }
    }
  }
  // 300 spheres in one place: each by its number where the ray comes in, and again where it goes out.
  const std::vector<SimpleScene> scenes = awkward_scenes();
  const auto same = std::find_if(scenes.begin(), scenes.end(), [](const SimpleScene& scene) { return scene.name == "all the same"; });
  REQUIRE(same != scenes.end());
  for (const AcceleratorKind kind : kAccelerators) {
    const auto accelerator = make_accelerator(kind, same->items, workers);
    Traversal traversal;
    Ray ray{.origin = {0.3, 0.2, 3}, .direction = {0, 0, -1}};
    for (int i = 0; i < 600; ++i) {
      const Hit hit = accelerator->nearest(ray, traversal);
      REQUIRE(hit.item == i % 300);
      ray.t_min = hit.t;
      ray.first_item_at_t_min = hit.item + 1;
    }
    CHECK(!accelerator->nearest(ray, traversal));
  }
}

TEST_CASE("accelerators: rays that are none meet nothing", "[accelerators][case-65]") {
  Workers workers(1);
  const double nan = std::nan("");
  const std::vector<Ray> unsound{{.direction = {0, 0, 0}},
                                 {.origin = {nan, 0, 0}},
                                 {.direction = {nan, 0, 1}},
                                 {.origin = {0, kInfinity, 0}},
                                 {.direction = {0, 0, -kInfinity}},
                                 {.t_min = 2, .t_max = 1},
                                 {.t_min = 1, .t_max = 1},
                                 {.t_min = nan},
                                 {.t_max = nan}};
  for (const SimpleScene& scene : awkward_scenes())
    for (const AcceleratorKind kind : kAccelerators) {
      INFO(scene.name << ", " << name_of(kind));
      const auto accelerator = make_accelerator(kind, scene.items, workers);
      Traversal traversal;
      for (const Ray& ray : unsound) {
        CHECK(accelerator->nearest(ray, traversal) == Hit{});
        CHECK_FALSE(accelerator->any(ray, traversal));
      }
      // Nor do they cost anything.
      CHECK(traversal.work == TraversalWork{.rays = 18, .item_tests = 0, .volume_tests = 0});
    }
}

TEST_CASE("accelerators: numbers so large that their squares are infinite", "[accelerators]") {
  Workers workers(1);
  SimpleScene scene = scattered("", 200, {0, 0, 0}, 1, 3);
  scene.items.add_box({1e200, 0, 0}, {1e199, 1, 1});
  scene.items.add_box({1e300, 0, 0}, {1e300, 1e300, 1e300});
  scene.items.add_box({-1e90, 0, 0}, {1e89, 1e89, 1e89});
  std::vector<Ray> rays = awkward_rays(scene, 500, 4);
  for (int i = 0; i < 500; ++i) {
    rays.push_back({.origin = rays[i].origin * 1e100, .direction = rays[i].direction});
    rays.push_back({.origin = rays[i].origin, .direction = rays[i].direction * 1e-200});
    rays.push_back({.origin = rays[i].origin, .direction = rays[i].direction * 1e200});
  }
  for (const double distance : {1e120, 1e200, 1e300}) rays.push_back({.origin = {distance, 0, 0}, .direction = {-1, 0, 0}});
  for (const AcceleratorKind kind : kAccelerators) {
    INFO(name_of(kind));
    CHECK(wrong_answers(*make_accelerator(kind, scene.items, workers), scene.items, rays) == 0);
  }
}

TEST_CASE("accelerators: rays from so far away that they cannot tell one voxel from the next", "[accelerators]") {
  Workers workers(1);
  const SimpleScene scene = scattered("", 2000, {0, 0, 0}, 1, 10);
  for (const double distance : {1e6, 1e9, 1e12, 1e14}) {
    std::vector<Ray> rays = awkward_rays(scene, 1000, 11);
    for (Ray& ray : rays) ray = {.origin = ray.origin - distance * glm::normalize(ray.direction), .direction = glm::normalize(ray.direction)};
    for (const AcceleratorKind kind : kAccelerators) {
      INFO(name_of(kind) << " from " << distance);
      CHECK(wrong_answers(*make_accelerator(kind, scene.items, workers), scene.items, rays) == 0);
    }
  }
}

TEST_CASE("accelerators: the same for any number of workers", "[accelerators][threads]") {
  const SimpleScene scene = scattered("", 40000, {0, 0, 0}, 1, 5);
  const std::vector<Ray> rays = awkward_rays(scene, 500, 6);
  for (const AcceleratorKind kind : kAccelerators) {
    if (kind == AcceleratorKind::none) continue;
    INFO(name_of(kind));
    std::vector<TraversalWork> work;
    std::vector<AcceleratorFacts> facts;
    for (const int threads : {1, 2, 7}) {
      Workers workers(threads);
      const auto accelerator = make_accelerator(kind, scene.items, workers);
      Traversal traversal;
      for (const Ray& ray : rays) accelerator->nearest(ray, traversal), accelerator->any(ray, traversal);
      work.push_back(traversal.work);
      facts.push_back(accelerator->facts());
    }
    for (std::size_t i = 1; i < work.size(); ++i) {
      CHECK(work[i] == work[0]);
      CHECK(facts[i].volumes == facts[0].volumes);
      CHECK(facts[i].memory_bytes == facts[0].memory_bytes);
      CHECK(facts[i].depth == facts[0].depth);
    }
  }
}

TEST_CASE("accelerators: planes without end are asked by every ray", "[accelerators]") {
  Workers workers(1);
  SimpleItems items;
  for (int i = 0; i < 5; ++i) items.add_plane(-i);
  items.add_sphere({0, 0, 10}, 1);
  for (const AcceleratorKind kind : kAccelerators) {
    INFO(name_of(kind));
    Traversal traversal;
    const auto accelerator = make_accelerator(kind, items, workers);
    CHECK(accelerator->nearest({.origin = {0, 0, 5}}, traversal).item == 0);
    CHECK(traversal.work.item_tests == (kind == AcceleratorKind::none ? 6 : 5));
  }
}

TEST_CASE("accelerators: one memory serves several of any size, and numbers of rays may run out", "[accelerators]") {
  Workers workers(1);
  const SimpleScene few = scattered("", 20, {0, 0, 0}, 1, 7), many = scattered("", 2000, {0, 0, 0}, 1, 8);
  std::vector<Ray> rays = awkward_rays(many, 500, 9);
  std::erase_if(rays, [&](const Ray& ray) { return !asked_of_all(many.items, ray); });
  for (const AcceleratorKind kind : kAccelerators) {
    INFO(name_of(kind));
    const auto of_few = make_accelerator(kind, few.items, workers), of_many = make_accelerator(kind, many.items, workers);
    Traversal traversal;
    int wrong = 0;
    const auto ask_both = [&] {
      for (const Ray& ray : rays) {
        wrong += of_many->nearest(ray, traversal) != asked_of_all(many.items, ray);
        wrong += of_few->nearest(ray, traversal) != asked_of_all(few.items, ray);
      }
    };
    ask_both();
    // Numbers begin anew: every ray has the number that it had the first time.
    traversal.ray_number = 0xffffffff;
    ask_both();
    CHECK(wrong == 0);
    CHECK(rays.size() > 100);
  }
}
