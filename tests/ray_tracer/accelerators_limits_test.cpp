// Many items, and what memory they take.

#include <catch2/catch.hpp>

#include "reference/ray_tracer/accelerators/accelerator.hpp"
#include "tests/ray_tracer/accelerators_scenes.hpp"

using namespace tuberia;
using namespace tuberia::tracer;
using namespace tuberia::tracer::test;

namespace {

constexpr AcceleratorKind kAllButNone[] = {AcceleratorKind::bounding_spheres, AcceleratorKind::bvh, AcceleratorKind::grid, AcceleratorKind::octree};

// Nodes, references and voxels of all kinds, for each item.
constexpr std::int64_t kMostBytesPerItem = 320;

/// Some rays against asking every item; how much memory that took for each item.
void check_many(const std::string& name, const SimpleItems& items, std::span<const Ray> rays) {
  Workers workers;
  const auto none = make_accelerator(AcceleratorKind::none, items, workers);
  Traversal traversal;
  std::vector<Hit> expected;
  for (const Ray& ray : rays) expected.push_back(none->nearest(ray, traversal));
  for (const AcceleratorKind kind : kAllButNone) {
    INFO(name << ", " << name_of(kind));
    const auto accelerator = make_accelerator(kind, items, workers);
    int wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) wrong += accelerator->nearest(rays[i], traversal) != expected[i];
    CHECK(wrong == 0);
    CHECK(accelerator->facts().memory_bytes < kMostBytesPerItem * items.count());
    CHECK(accelerator->facts().memory_bytes > 4 * items.count());
    CHECK(accelerator->facts().build_seconds > 0);
  }
}

}  // namespace

TEST_CASE("accelerators: a million items", "[accelerators]") {
  const SimpleScene scene = scattered("a million", 1'000'000, {0, 0, 0}, 1, 21);
  check_many(scene.name, scene.items, awkward_rays(scene, 20, 22));
}

TEST_CASE("accelerators: a million items at one point", "[accelerators]") {
  SimpleScene scene{"at one point", {}, {}, 1};
  for (int i = 0; i < 1'000'000; ++i) scene.items.add_sphere({0.1, 0.2, 0.3}, 0.5);
  check_many(scene.name, scene.items, awkward_rays(scene, 20, 23));
}

TEST_CASE("accelerators: large items among many tiny ones take no more memory", "[accelerators]") {
  SimpleScene scene = scattered("large and tiny", 20'000, {0, 0, 0}, 1e-4, 24);
  scene.size = 1;
  for (const int large : {1, 100, 20'000}) {
    while (scene.items.count() < 20'000 + large) scene.items.add_sphere({0, 0, 0}, 1 + 1e-5 * static_cast<double>(scene.items.count()));
    check_many(std::to_string(large) + " large ones", scene.items, awkward_rays(scene, 100, 25));
  }
}

TEST_CASE("accelerators: settings that are none are as good as the nearest that are", "[accelerators]") {
  const SimpleScene scene = scattered("", 300, {0, 0, 0}, 1, 26);
  const std::vector<Ray> rays = awkward_rays(scene, 200, 27);
  Workers workers(1);
  Traversal traversal;
  const auto none = make_accelerator(AcceleratorKind::none, scene.items, workers);
  const AcceleratorSettings odd[] = {{0, 0, 0}, {-5, -1, -1}, {1, 1000, 1e300}, {1 << 30, 1 << 30, std::nan("")}};
  for (const AcceleratorKind kind : kAllButNone)
    for (const AcceleratorSettings& settings : odd) {
      INFO(name_of(kind) << " " << settings.most_items);
      const auto accelerator = make_accelerator(kind, scene.items, workers, settings);
      int wrong = 0;
      for (const Ray& ray : rays) wrong += accelerator->nearest(ray, traversal) != none->nearest(ray, traversal);
      CHECK(wrong == 0);
    }
}
