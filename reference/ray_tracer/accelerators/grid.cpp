#include "reference/ray_tracer/accelerators/grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/ray_tracer/accelerators/slabs.hpp"

namespace tuberia::tracer {
namespace {

// Of a voxel's edge. A thousandth more items; a ray from 10^9 voxels away still knows its voxels.
constexpr double kMargin = 1e-3;
constexpr double kSmallestMargin = 1e-200;  // where everything is at 0

/// The edge of cubes of which about `wanted` fill the box. Directions in which it is thinner than that are filled by
/// one, and the others share what is left.
double edge_of_voxels(const glm::dvec3& size, double wanted) noexcept {
  std::array<double, 3> sizes{size.x, size.y, size.z};
  std::sort(sizes.begin(), sizes.end());
  const double volume_edge = std::cbrt(sizes[0] / wanted * sizes[1] * sizes[2]);
  if (sizes[0] >= volume_edge && volume_edge > 0) return volume_edge;
  const double area_edge = std::sqrt(sizes[1] / wanted * sizes[2]);
  if (sizes[1] >= area_edge && area_edge > 0) return area_edge;
  return sizes[2] / wanted;
}

}  // namespace

std::int64_t Grid::Range::count() const noexcept {
  std::int64_t product = 1;
  for (int axis = 0; axis < 3; ++axis) product *= last[axis] - first[axis] + 1;
  return product;
}

Grid::Grid(const Items& items, Workers& workers, const AcceleratorSettings& settings) : SearchingAccelerator(items) {
  BoxedItems boxed = boxes_of(items, workers);
  set_unbounded(std::move(boxed.unbounded));
  facts_.memory_bytes = unbounded_bytes();
  if (boxed.bounded.empty()) return;
  largest_coordinate_ = boxed.largest_coordinate;

  const auto count = static_cast<std::int64_t>(boxed.bounded.size());
  // What is no number counts as 1.
  double wanted = std::min(std::max(1.0, settings.voxels_per_item * static_cast<double>(count)), static_cast<double>(kMostVoxels));
  choose_voxels(boxed.box, wanted);
  while (wanted > 1 && references(boxed.bounded) > kMostReferences * count) {
    wanted = std::max(1.0, wanted / 2);
    choose_voxels(boxed.box, wanted);
  }
  fill(boxed.bounded);

  facts_.volumes = static_cast<std::int64_t>(first_of_voxel_.size()) - 1;
  facts_.depth = 1;
  facts_.memory_bytes += static_cast<std::int64_t>((first_of_voxel_.capacity() + items_.capacity()) * sizeof(std::uint32_t));
}

void Grid::choose_voxels(const Box& box, double wanted) {
  const glm::dvec3 size = box.size();
  const double edge = edge_of_voxels(size, wanted);
  margin_ = std::max({kMargin * edge, slack_of(largest_coordinate_), kSmallestMargin});
  box_ = {box.lower - margin_, box.upper + margin_};
  for (int axis = 0; axis < 3; ++axis) {
    const double count = edge > 0 ? std::round(size[axis] / edge) : 1;
    counts_[axis] = static_cast<int>(std::clamp(count, 1.0, static_cast<double>(kMostVoxels)));
    voxel_size_[axis] = box_.size()[axis] / counts_[axis];
  }
}

int Grid::voxel_at(double coordinate, int axis) const noexcept {
  const double at = (coordinate - box_.lower[axis]) / voxel_size_[axis];
  return at > 0 ? static_cast<int>(std::min(at, counts_[axis] - 1.0)) : 0;
}

Grid::Range Grid::voxels_of(const Box& box) const noexcept {
  Range range{};
  for (int axis = 0; axis < 3; ++axis) {
    range.first[axis] = voxel_at(box.lower[axis] - margin_, axis);
    range.last[axis] = voxel_at(box.upper[axis] + margin_, axis);
  }
  return range;
}

std::int64_t Grid::references(const std::vector<BoxedItem>& items) const noexcept {
  std::int64_t sum = 0;
  for (const BoxedItem& each : items) sum += voxels_of(each.box).count();
  return sum;
}

std::size_t Grid::index(int x, int y, int z) const noexcept {
  const auto rows = static_cast<std::size_t>(y) + static_cast<std::size_t>(counts_[1]) * static_cast<std::size_t>(z);
  return static_cast<std::size_t>(x) + static_cast<std::size_t>(counts_[0]) * rows;
}

template <class Visit>
void Grid::for_each_voxel(const Range& range, Visit&& visit) const {
  for (int z = range.first[2]; z <= range.last[2]; ++z)
    for (int y = range.first[1]; y <= range.last[1]; ++y)
      for (int x = range.first[0]; x <= range.last[0]; ++x) visit(index(x, y, z));
}

void Grid::fill(const std::vector<BoxedItem>& items) {
  // How many each voxel has, then where each one's items end; putting them in from the end on leaves where they begin.
  first_of_voxel_.assign(index(0, 0, counts_[2]) + 1, 0);
  for (const BoxedItem& each : items) for_each_voxel(voxels_of(each.box), [&](std::size_t voxel) { ++first_of_voxel_[voxel]; });
  for (std::size_t i = 1; i < first_of_voxel_.size(); ++i) first_of_voxel_[i] += first_of_voxel_[i - 1];
  items_.resize(first_of_voxel_.back());
  for (auto each = items.rbegin(); each != items.rend(); ++each)
    for_each_voxel(voxels_of(each->box), [&](std::size_t voxel) { items_[--first_of_voxel_[voxel]] = each->item; });
}

/// From voxel to voxel along a ray. The walls are computed, not summed up: after thousands of voxels they are
/// where the items were sorted by them.
class Grid::Walk {
 public:
  Walk(const Grid& grid, const Ray& ray, double entry) noexcept : grid_(grid), ray_(ray), inverse_(1.0 / ray.direction) {
    const glm::dvec3 at = ray.at(entry);
    for (int axis = 0; axis < 3; ++axis) {
      voxel_[axis] = grid.voxel_at(at[axis], axis);
      step_[axis] = ray.direction[axis] > 0 ? 1 : -1;
      next_wall_[axis] = wall(axis);
    }
    choose_axis();
  }

  std::size_t voxel() const noexcept { return grid_.index(voxel_[0], voxel_[1], voxel_[2]); }
  /// Where the ray leaves it.
  double exit() const noexcept { return next_wall_[axis_]; }
  /// Whether there is another one.
  bool step() noexcept {
    voxel_[axis_] += step_[axis_];
    if (voxel_[axis_] < 0 || voxel_[axis_] >= grid_.counts_[axis_]) return false;
    next_wall_[axis_] = wall(axis_);
    choose_axis();
    return true;
  }

 private:
  double wall(int axis) const noexcept {
    if (ray_.direction[axis] == 0) return kInfinity;
    const int walls = voxel_[axis] + (step_[axis] > 0 ? 1 : 0);
    return (grid_.box_.lower[axis] + walls * grid_.voxel_size_[axis] - ray_.origin[axis]) * inverse_[axis];
  }
  void choose_axis() noexcept { axis_ = next_wall_[0] <= next_wall_[1] && next_wall_[0] <= next_wall_[2] ? 0 : next_wall_[1] <= next_wall_[2] ? 1 : 2; }

  const Grid& grid_;
  const Ray& ray_;
  glm::dvec3 inverse_;
  std::array<int, 3> voxel_{}, step_{};
  std::array<double, 3> next_wall_{};
  int axis_ = 0;
};

void Grid::search(Search& search) const noexcept {
  if (first_of_voxel_.empty()) return;
  search.open_mailboxes();
  const Ray& ray = search.ray();
  if (slack_of(largest_component(ray.origin)) > margin_) {
    // From so far away that the ray does not know which voxels it passes.
    for (std::size_t i = 0; i < items_.size() && !search.is_over(); ++i) search.ask_once(items_[i]);
    return;
  }
  const double entry = Slabs(ray, largest_coordinate_).entry(box_, search.limit());
  if (entry == kInfinity) return;

  Walk walk(*this, ray, entry);
  do {
    search.count_volume();
    const std::size_t voxel = walk.voxel();
    for (std::uint32_t i = first_of_voxel_[voxel]; i < first_of_voxel_[voxel + 1]; ++i) {
      search.ask_once(items_[i]);
      if (search.is_over()) return;
    }
    // A hit in this voxel is the nearest. One farther on waits: something in between may be nearer.
  } while (search.limit() > walk.exit() && walk.step());
}

}  // namespace tuberia::tracer
