#include "reference/ray_tracer/accelerators/octree.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "reference/ray_tracer/accelerators/slabs.hpp"

namespace tuberia::tracer {
namespace {

/// The halves of a voxel that a ray comes to first and last, along every axis: the wall between them is where the ray is
/// half way through.
std::array<Slabs::Walls, 2> halves_of(const Slabs::Walls& walls, const glm::dvec3& slack) noexcept {
  const glm::dvec3 middle = 0.5 * walls.in + 0.5 * walls.out;
  return {{{walls.in, middle + slack}, {middle - slack, walls.out}}};
}

/// The bits of the number say which half along x, y and z, as the ray meets them.
Slabs::Walls part_of(const std::array<Slabs::Walls, 2>& halves, unsigned number) noexcept {
  const Slabs::Walls &x = halves[number & 1], &y = halves[number >> 1 & 1], &z = halves[number >> 2 & 1];
  return {{x.in.x, y.in.y, z.in.z}, {x.out.x, y.out.y, z.out.z}};
}

}  // namespace

Octree::Voxel Octree::Voxel::part(unsigned number) const noexcept {
  const double half = 0.5 * edge;
  return {lower + half * glm::dvec3(number & 1, number >> 1 & 1, number >> 2 & 1), half};
}

/// Level by level, so that where memory ends all places have been refined alike.
class Octree::Builder {
 public:
  Builder(Octree& to, const std::vector<BoxedItem>& items, Workers& workers, const AcceleratorSettings& settings)
      : to_(to), items_(items), workers_(workers), most_items_(static_cast<std::uint32_t>(std::max(settings.most_items, 1))),
        most_depth_(std::clamp(settings.most_depth, 0, kDeepest)), reference_count_(static_cast<std::int64_t>(items.size())) {}

  void build() {
    std::vector<std::uint32_t> all(items_.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    to_.nodes_.resize(1);
    Level level{{{0, to_.root_, 0, static_cast<std::uint32_t>(all.size())}}, std::move(all)};
    for (int depth = 0; !level.voxels.empty(); ++depth) {
      to_.facts_.depth = depth + 1;
      level = next(level, depth < most_depth_);
    }
  }

 private:
  struct Open {
    std::uint32_t node = 0;
    Voxel voxel;
    std::uint32_t first = 0, count = 0;  // of its level's items
    std::array<std::uint32_t, 8> counts{};  // of its parts
    std::uint32_t parts_first = 0;          // where their items begin in the next level
    bool is_cut = false;
  };
  struct Level {
    std::vector<Open> voxels;
    std::vector<std::uint32_t> items;
  };

  /// Calls visit(part) for those of the eight that the item touches; it touches the voxel.
  template <class Visit>
  static void for_each_part(const Voxel& voxel, const Box& box, Visit&& visit) {
    const glm::dvec3 middle = voxel.lower + 0.5 * voxel.edge;
    // Bit 0: below the middle, bit 1: above it.
    std::array<unsigned, 3> sides{};
    for (int axis = 0; axis < 3; ++axis) sides[axis] = (box.lower[axis] <= middle[axis] ? 1u : 0u) | (box.upper[axis] >= middle[axis] ? 2u : 0u);
    for (unsigned part = 0; part < 8; ++part)
      if (sides[0] >> (part & 1) & sides[1] >> (part >> 1 & 1) & sides[2] >> (part >> 2 & 1) & 1) visit(part);
  }

  /// Decides which voxels of a level are leaves, and makes the next level of the parts of the others.
  Level next(Level& level, bool may_cut) {
    const auto count = static_cast<std::int64_t>(level.voxels.size());
    if (may_cut) parallel_for(workers_, count, [&](std::int64_t i, int) { count_parts(level.voxels[static_cast<std::size_t>(i)], level.items); });
    Level below;
    for (Open& open : level.voxels)
      if (may_cut && is_worth_cutting(open)) cut(open, below);
      else make_leaf(open, level.items);
    parallel_for(workers_, count, [&](std::int64_t i, int) { hand_down(level.voxels[static_cast<std::size_t>(i)], level.items, below.items); });
    // Parts without items are leaves already.
    std::erase_if(below.voxels, [](const Open& open) { return open.count == 0; });
    return below;
  }

  void count_parts(Open& open, const std::vector<std::uint32_t>& items) const {
    if (open.count <= most_items_) return;
    for (std::uint32_t i = open.first; i < open.first + open.count; ++i)
      for_each_part(open.voxel, items_[items[i]].box, [&](unsigned part) { ++open.counts[part]; });
  }

  bool is_worth_cutting(const Open& open) const {
    // A ray passes two to four of the parts: where items are in more, cutting saves no tests.
    constexpr std::int64_t kMostCopies = 3;
    if (open.count <= most_items_) return false;
    std::int64_t sum = 0;
    for (const std::uint32_t each : open.counts) sum += each;
    const auto budget = static_cast<std::int64_t>(items_.size());
    return sum <= kMostCopies * open.count && reference_count_ + sum - open.count <= kMostReferences * budget &&
           static_cast<std::int64_t>(to_.nodes_.size()) + 8 <= kMostVoxels * budget + 1024;
  }

  void cut(Open& open, Level& below) {
    open.is_cut = true;
    open.parts_first = static_cast<std::uint32_t>(below.items.size());
    const auto parts = static_cast<std::uint32_t>(to_.nodes_.size());
    to_.nodes_[open.node] = {parts, kCut};
    to_.nodes_.resize(to_.nodes_.size() + 8);
    std::uint32_t first = open.parts_first;
    for (unsigned part = 0; part < 8; ++part) {
      below.voxels.push_back({.node = parts + part, .voxel = open.voxel.part(part), .first = first, .count = open.counts[part]});
      first += open.counts[part];
    }
    below.items.resize(first);
    reference_count_ += static_cast<std::int64_t>(first - open.parts_first) - open.count;
  }

  void make_leaf(const Open& open, const std::vector<std::uint32_t>& items) {
    to_.nodes_[open.node] = {static_cast<std::uint32_t>(to_.items_.size()), open.count};
    for (std::uint32_t i = open.first; i < open.first + open.count; ++i) to_.items_.push_back(items_[items[i]].item);
  }

  void hand_down(const Open& open, const std::vector<std::uint32_t>& items, std::vector<std::uint32_t>& below) const {
    if (!open.is_cut) return;
    std::array<std::uint32_t, 8> next{};
    std::uint32_t first = open.parts_first;
    for (unsigned part = 0; part < 8; first += open.counts[part++]) next[part] = first;
    for (std::uint32_t i = open.first; i < open.first + open.count; ++i)
      for_each_part(open.voxel, items_[items[i]].box, [&](unsigned part) { below[next[part]++] = items[i]; });
  }

  Octree& to_;
  const std::vector<BoxedItem>& items_;
  Workers& workers_;
  std::uint32_t most_items_;
  int most_depth_;
  std::int64_t reference_count_;
};

Octree::Octree(const Items& items, Workers& workers, const AcceleratorSettings& settings) : SearchingAccelerator(items) {
  BoxedItems boxed = boxes_of(items, workers);
  set_unbounded(std::move(boxed.unbounded));
  largest_coordinate_ = boxed.largest_coordinate;
  if (!boxed.bounded.empty()) {
    const glm::dvec3 size = boxed.box.size();
    root_ = {boxed.box.lower, std::max({size.x, size.y, size.z})};
    Builder(*this, boxed.bounded, workers, settings).build();
    nodes_.shrink_to_fit();
    items_.shrink_to_fit();
  }
  facts_.volumes = static_cast<std::int64_t>(nodes_.size());
  facts_.memory_bytes = unbounded_bytes() + static_cast<std::int64_t>(nodes_.capacity() * sizeof(Node) + items_.capacity() * sizeof(std::uint32_t));
}

void Octree::search(Search& search) const noexcept {
  if (nodes_.empty()) return;
  search.open_mailboxes();
  const Ray& ray = search.ray();
  const Slabs slabs(ray, largest_coordinate_ + root_.edge);
  // Counted along the ray no part lies behind one with a larger number; these bits make that the number in the node.
  const unsigned backwards = (ray.direction.x < 0 ? 1u : 0u) | (ray.direction.y < 0 ? 2u : 0u) | (ray.direction.z < 0 ? 4u : 0u);

  struct Waiting {
    std::uint32_t node;
    double entry;
    Slabs::Walls walls;
  };
  std::array<Waiting, 7 * kDeepest + 8> waiting;
  std::size_t waiting_count = 0;
  const auto push = [&](std::uint32_t node, const Slabs::Walls& walls) {
    if (const double entry = slabs.entry(walls, search.limit()); entry < kInfinity) waiting[waiting_count++] = {node, entry, walls};
  };

  push(0, slabs.walls(root_.box()));
  while (waiting_count > 0) {
    const Waiting next = waiting[--waiting_count];
    if (next.entry > search.limit()) continue;
    const Node& node = nodes_[next.node];
    if (node.count == kCut) {
      // The farthest part first, so that the nearest is taken up next.
      const std::array<Slabs::Walls, 2> halves = halves_of(next.walls, slabs.slack());
      for (unsigned i = 8; i-- > 0;) push(node.first + (i ^ backwards), part_of(halves, i));
      continue;
    }
    search.count_volume();
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      search.ask_once(items_[i]);
      if (search.is_over()) return;
    }
  }
}

}  // namespace tuberia::tracer
