#include "reference/ray_tracer/accelerators/bounding_spheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "reference/ray_tracer/accelerators/slabs.hpp"

namespace tuberia::tracer {
namespace {

constexpr std::size_t kDeepest = 34;  // groups are halved, and their items are fewer than 2^32

/// A ray as spheres see it. Every sphere counts as larger by the slack.
class SphereTest {
 public:
  SphereTest(const Ray& ray, double largest_coordinate) noexcept
      : origin_(ray.origin), direction_(glm::normalize(ray.direction)), per_length_(1 / glm::length(ray.direction)),
        slack_(slack_of(std::max(largest_coordinate, largest_component(ray.origin)))), t_min_(ray.t_min) {}

  /// Where the ray comes to be in the sphere, at t_min or later, but at `limit` at the latest; infinity if nowhere.
  double entry(const BoundingSphere& sphere, double limit) const noexcept {
    const glm::dvec3 to_centre = sphere.centre - origin_;
    const double middle = glm::dot(to_centre, direction_);
    const glm::dvec3 aside = to_centre - middle * direction_;
    const double radius = sphere.radius + slack_, rest = radius * radius - glm::dot(aside, aside);
    if (rest < 0) return kInfinity;
    const double half = std::sqrt(rest) + slack_;
    const double first = std::max((middle - half) * per_length_, t_min_), last = std::min((middle + half) * per_length_, limit);
    return first <= last ? first : kInfinity;
  }

 private:
  glm::dvec3 origin_, direction_;
  double per_length_, slack_, t_min_;
};

}  // namespace

/// Halves groups along the longest extent of their items' centres.
class BoundingSpheres::Builder {
 public:
  Builder(BoundingSpheres& to, std::size_t most_items) : to_(to), most_items_(most_items) {}

  void build() {
    if (to_.items_.empty()) return;
    to_.groups_.resize(1);
    fill(0, 0, to_.items_.size(), 1);
  }

 private:
  void fill(std::size_t group, std::size_t first, std::size_t count, int depth) {
    const std::span<ItemSphere> items = std::span(to_.items_).subspan(first, count);
    to_.facts_.depth = std::max(to_.facts_.depth, depth);
    to_.groups_[group].sphere = around(items);
    if (count <= most_items_) {
      to_.groups_[group].first = static_cast<std::uint32_t>(first);
      to_.groups_[group].count = static_cast<std::uint32_t>(count);
      return;
    }
    const std::size_t half = count / 2, pair = to_.groups_.size();
    halve(items);
    to_.groups_[group].first = static_cast<std::uint32_t>(pair);
    to_.groups_.resize(pair + 2);
    fill(pair, first, half, depth + 1);
    fill(pair + 1, first + half, count - half, depth + 1);
  }

  /// Around the centroid, as far as the farthest item.
  static BoundingSphere around(std::span<const ItemSphere> items) {
    BoundingSphere all;
    const double share = 1 / static_cast<double>(items.size());
    for (const ItemSphere& each : items) all.centre += share * each.sphere.centre;
    for (const ItemSphere& each : items) all.radius = std::max(all.radius, glm::length(each.sphere.centre - all.centre) + each.sphere.radius);
    return all;
  }

  static void halve(std::span<ItemSphere> items) {
    Box centres;
    for (const ItemSphere& each : items) centres.add(each.sphere.centre);
    const glm::dvec3 size = centres.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto middle = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
    std::nth_element(items.begin(), middle, items.end(), [axis](const ItemSphere& a, const ItemSphere& b) {
      return std::pair(a.sphere.centre[axis], a.item) < std::pair(b.sphere.centre[axis], b.item);
    });
  }

  BoundingSpheres& to_;
  std::size_t most_items_;
};

BoundingSpheres::BoundingSpheres(const Items& items, Workers& workers, const AcceleratorSettings& settings) : SearchingAccelerator(items) {
  BoxedItems boxed = boxes_of(items, workers);
  for (const BoxedItem& each : boxed.bounded) {
    items_.push_back({items.bounding_sphere(each.item), each.item});
    const BoundingSphere& sphere = items_.back().sphere;
    largest_coordinate_ = std::max(largest_coordinate_, largest_component(sphere.centre) + sphere.radius);
  }
  set_unbounded(std::move(boxed.unbounded));
  Builder(*this, static_cast<std::size_t>(std::max(settings.most_items, 1))).build();
  facts_.volumes = static_cast<std::int64_t>(groups_.size() + items_.size());
  facts_.memory_bytes = unbounded_bytes() + static_cast<std::int64_t>(groups_.capacity() * sizeof(Group) + items_.capacity() * sizeof(ItemSphere));
}

void BoundingSpheres::search(Search& search) const noexcept {
  const SphereTest test(search.ray(), largest_coordinate_);
  const auto entry_of = [&](const BoundingSphere& sphere) {
    search.count_volume();
    return test.entry(sphere, search.limit());
  };
  struct Waiting {
    std::uint32_t group;
    double entry;
  };
  std::array<Waiting, kDeepest> waiting;
  std::size_t waiting_count = 0;
  if (!groups_.empty()) waiting[waiting_count++] = {0, entry_of(groups_[0].sphere)};

  while (waiting_count > 0) {
    const Waiting next = waiting[--waiting_count];
    if (next.entry > search.limit() || next.entry == kInfinity) continue;
    const Group& group = groups_[next.group];
    if (group.count == 0) {
      // The nearer of the two comes first.
      Waiting nearer{group.first, entry_of(groups_[group.first].sphere)}, farther{group.first + 1, entry_of(groups_[group.first + 1].sphere)};
      if (farther.entry < nearer.entry) std::swap(nearer, farther);
      waiting[waiting_count++] = farther;
      waiting[waiting_count++] = nearer;
    }
    for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
      if (entry_of(items_[i].sphere) == kInfinity) continue;
      search.ask(items_[i].item);
      if (search.is_over()) return;
    }
  }
}

}  // namespace tuberia::tracer
