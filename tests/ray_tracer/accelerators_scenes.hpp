#pragma once
// Things to find, and rays that look for them: what every accelerator is compared on.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reference/ray_tracer/items.hpp"
#include "tests/support/random.hpp"

namespace tuberia::tracer::test {

using tuberia::test::Random;

/// Spheres and boxes along the axes, flat ones among them, and planes without end.
class SimpleItems final : public Items {
 public:
  enum class Kind : std::uint8_t { sphere, box, plane };
  struct Item {
    Kind kind = Kind::sphere;
    glm::dvec3 centre{0};
    glm::dvec3 half_size{1};  // a sphere's radius is x; a plane faces z
  };

  std::vector<Item> items;

  void add_sphere(const glm::dvec3& centre, double radius) { items.push_back({Kind::sphere, centre, glm::dvec3(radius)}); }
  void add_box(const glm::dvec3& centre, const glm::dvec3& half_size) { items.push_back({Kind::box, centre, half_size}); }
  void add_plane(double z) { items.push_back({Kind::plane, {0, 0, z}, {kInfinity, kInfinity, 0}}); }

  std::int64_t count() const noexcept override { return static_cast<std::int64_t>(items.size()); }
  Box bounds(std::int64_t i) const noexcept override {
    const Item& item = items[static_cast<std::size_t>(i)];
    return {item.centre - item.half_size, item.centre + item.half_size};
  }
  bool intersect(std::int64_t i, const PreparedRay& prepared, Hit& nearest) const noexcept override {
    const Item& item = items[static_cast<std::size_t>(i)];
    const Ray& ray = prepared.ray;
    if (bounds(i).empty()) return false;
    const std::pair<double, double> along = item.kind == Kind::sphere ? sphere(item, ray) : slabs(item, ray);
    for (const double t : {along.first, along.second})
      if (t > ray.t_min && t < ray.t_max) {
        if (!nearest.is_beaten_by(t, i)) return false;
        nearest = {.t = t, .item = i};
        return true;
      }
    return false;
  }

 private:
  /// Both ends of the ray in it, in order; infinite or reversed where there are none.
  static std::pair<double, double> sphere(const Item& item, const Ray& ray) noexcept {
    const double square = glm::dot(ray.direction, ray.direction);
    const glm::dvec3 to_centre = item.centre - ray.origin;
    const double middle = glm::dot(to_centre, ray.direction) / square;
    const glm::dvec3 aside = to_centre - middle * ray.direction;
    const double rest = item.half_size.x * item.half_size.x - glm::dot(aside, aside);
    if (!(rest > 0)) return {kInfinity, kInfinity};
    const double half = std::sqrt(rest / square);
    return {middle - half, middle + half};
  }
  static std::pair<double, double> slabs(const Item& item, const Ray& ray) noexcept {
    double in = -kInfinity, out = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
      const double lower = item.centre[axis] - item.half_size[axis] - ray.origin[axis], upper = item.centre[axis] + item.half_size[axis] - ray.origin[axis];
      if (ray.direction[axis] == 0) {
        if (lower > 0 || upper < 0) return {kInfinity, kInfinity};
        continue;
      }
      const double a = lower / ray.direction[axis], b = upper / ray.direction[axis];
      in = std::max(in, std::min(a, b));
      out = std::min(out, std::max(a, b));
    }
    if (in > out) return {kInfinity, kInfinity};
    return {in, out};
  }
};

struct SimpleScene {
  std::string name;
  SimpleItems items;
  glm::dvec3 middle{0};
  double size = 1;  // about: where rays are worth sending
};

inline glm::dvec3 random_in_cube(Random& random) { return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}; }

inline glm::dvec3 random_direction(Random& random) {
  for (;;) {
    const glm::dvec3 v = random_in_cube(random);
    if (const double length = glm::length(v); length > 0.1 && length < 1) return v / length;
  }
}

/// Spheres and boxes of many sizes in a cube.
inline SimpleScene scattered(const std::string& name, int count, const glm::dvec3& middle, double size, std::uint64_t seed) {
  Random random(seed);
  SimpleScene scene{name, {}, middle, size};
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 at = middle + size * random_in_cube(random);
    const double radius = size * std::pow(0.5, random.between(1, 8)) / std::cbrt(count);
    if (i % 3 == 0) scene.items.add_box(at, radius * glm::dvec3(random.between(0, 2), random.between(0, 2), random.between(0, 2)));
    else scene.items.add_sphere(at, radius);
  }
  return scene;
}

/// Every shape of scene that an accelerator might stumble over.
inline std::vector<SimpleScene> awkward_scenes() {
  std::vector<SimpleScene> scenes{{"nothing", {}, {}, 1}, {"one sphere", {}, {}, 1}};
  scenes[1].items.add_sphere({0, 0, 0}, 0.5);
  scenes.push_back(scattered("few", 7, {0, 0, 0}, 1, 1));
  scenes.push_back(scattered("many", 3000, {0, 0, 0}, 1, 2));
  scenes.push_back(scattered("small numbers", 500, {0, 0, 0}, 1e-3, 3));
  scenes.push_back(scattered("large numbers", 500, {0, 0, 0}, 1e6, 4));
  scenes.push_back(scattered("far from 0", 500, {148376, 1234, -223423}, 6, 5));
  scenes.push_back(scattered("small and far from 0", 500, {1e6, -1e6, 1e6}, 1e-3, 6));

  SimpleScene same{"all the same", {}, {}, 1};
  for (int i = 0; i < 300; ++i) same.items.add_sphere({0.25, 0.25, 0.25}, 0.5);
  scenes.push_back(same);
  SimpleScene concentric{"around one centre", {}, {}, 1};
  for (int i = 1; i <= 300; ++i) concentric.items.add_sphere({0, 0, 0}, i / 300.0);
  scenes.push_back(concentric);
  SimpleScene points{"points", {}, {}, 1};
  for (int i = 0; i < 300; ++i) points.items.add_box({i / 150.0 - 1, 0, 0}, {0, 0, 0});
  scenes.push_back(points);

  // Tiles of a floor without thickness, edge to edge: where they meet the smaller number wins.
  SimpleScene floor{"a flat floor", {}, {}, 1};
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) floor.items.add_box({(x - 7.5) / 8, (y - 7.5) / 8, 0}, {0.0625, 0.0625, 0});
  scenes.push_back(floor);
  SimpleScene blocks{"blocks that touch", {}, {}, 1};
  for (int i = 0; i < 512; ++i) blocks.items.add_box(glm::dvec3(i % 8 - 3.5, i / 8 % 8 - 3.5, i / 64 - 3.5) / 4.0, glm::dvec3(0.125));
  scenes.push_back(blocks);

  SimpleScene stadium = scattered("a teapot in a stadium", 1000, {0.3, 0.3, 0.3}, 1e-3, 7);
  stadium.items.add_box({0, 0, 0}, {1, 1, 1});
  stadium.size = 1;
  scenes.push_back(stadium);
  SimpleScene planes = scattered("planes among spheres", 200, {0, 0, 0}, 1, 8);
  planes.items.add_plane(-0.75);
  planes.items.add_plane(0.5);
  scenes.push_back(planes);
  SimpleScene hidden = scattered("items that nothing meets", 100, {0, 0, 0}, 1, 9);
  hidden.items.add_box({0, 0, 0}, {-1, -1, -1});
  hidden.items.add_box({0, 0, 0}, glm::dvec3(std::nan("")));
  scenes.push_back(hidden);
  return scenes;
}

/// Rays of every kind at a scene: from outside and inside, at items, along axes, on walls, with ends.
inline std::vector<Ray> awkward_rays(const SimpleScene& scene, int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Ray> rays;
  const auto some_item = [&] {
    if (scene.items.items.empty()) return scene.middle;
    const glm::dvec3 centre = scene.items.items[static_cast<std::size_t>(random.below(scene.items.count()))].centre;
    return std::isfinite(centre.x) ? centre : scene.middle;
  };
  for (int i = 0; i < count; ++i) {
    Ray ray{.origin = scene.middle + 2 * scene.size * random_in_cube(random), .direction = random_direction(random)};
    if (i % 2 == 0)
      if (const glm::dvec3 there = some_item() - ray.origin; there != glm::dvec3(0)) ray.direction = glm::normalize(there);
    if (i % 7 == 1) ray.direction[static_cast<int>(random.below(3))] = 0;
    if (i % 7 == 2) {
      ray.direction = {0, 0, 0};
      ray.direction[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1 : -1;
    }
    if (i % 11 == 3) ray.origin = some_item();
    // On the walls of voxels and of blocks, and in the plane of the floor.
    if (i % 5 == 4) ray.origin = scene.middle + scene.size * glm::round(8.0 * random_in_cube(random)) / 8.0;
    if (i % 13 == 5) ray.t_max = scene.size * random.between(0.1f, 3);
    if (i % 13 == 6) ray.t_min = scene.size * random.between(-1, 2);
    if (i % 17 == 7) ray.origin = scene.middle - 1e4 * scene.size * ray.direction;
    if (i % 19 == 8) ray.direction *= random.between(0.01f, 100);
    rays.push_back(ray);
  }
  return rays;
}

}  // namespace tuberia::tracer::test
