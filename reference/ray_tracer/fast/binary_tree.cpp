#include "reference/ray_tracer/fast/binary_tree.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "reference/ray_tracer/fast/wide_tree.hpp"

namespace tuberia::tracer {

namespace {

constexpr int kBins = 16;

// A ray that meets a node's box tests this much for every block of triangles that it then tests. Nodes are tested eight at
// a time, so a further level costs little.
constexpr float kNodeCost = 0.5f;

// Ranges of more triangles are split level by level, all of a level in parallel; smaller ones are a task each.
constexpr std::uint32_t kTaskSize = 4096;

float half_area(const Bounds& box) noexcept {
  const glm::vec3 size = box.upper - box.lower;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

// Twice the middle of a box, which sorts like the middle.
glm::vec3 doubled_centre(const Bounds& box) noexcept { return box.lower + box.upper; }

struct Bin {
  Bounds bounds;
  std::uint32_t count = 0;

  void add(const Bin& other) noexcept {
    bounds.add(other.bounds);
    count += other.count;
  }
};

struct Split {
  float cost = 0;
  int axis = 0;
  int first_right_bin = 0;
};

class Builder {
 public:
  Builder(std::span<BoxedTriangle> triangles, int most_in_leaf)
      : triangles_(triangles), most_in_leaf_(static_cast<std::uint32_t>(most_in_leaf)), nodes_(2 * triangles.size()) {}

  std::vector<BinaryNode> build(Workers& workers) {
    set_range(0, 0, static_cast<std::uint32_t>(triangles_.size()));
    std::vector<Place> level{{0, 0}}, tasks;
    while (!level.empty()) {
      parallel_for(workers, static_cast<std::int64_t>(level.size()), [&](std::int64_t i, int) { split(level[i]); });
      std::vector<Place> next;
      for (const Place& parent : level)
        if (!nodes_[parent.node].is_leaf())
          for (const Place& child : {left_of(parent), right_of(parent)}) (nodes_[child.node].count > kTaskSize ? next : tasks).push_back(child);
      level = std::move(next);
    }
    parallel_for(workers, static_cast<std::int64_t>(tasks.size()), [&](std::int64_t i, int) { build_below(tasks[i]); });
    return std::move(nodes_);
  }

 private:
  struct Place {
    std::uint32_t node = 0;
    int depth = 0;
  };

  Place left_of(const Place& parent) const noexcept { return {parent.node + 1, parent.depth + 1}; }
  Place right_of(const Place& parent) const noexcept { return {nodes_[parent.node].right, parent.depth + 1}; }

  void set_range(std::uint32_t node, std::uint32_t begin, std::uint32_t count) {
    nodes_[node].begin = begin;
    nodes_[node].count = count;
  }

  void build_below(const Place& place) {
    split(place);
    if (nodes_[place.node].is_leaf()) return;
    build_below(left_of(place));
    build_below(right_of(place));
  }

  // How many tests of a block a number of triangles takes.
  float blocks(std::uint32_t count) const noexcept { return static_cast<float>((count + most_in_leaf_ - 1) / most_in_leaf_); }

  // Finds the node's box, and makes it a leaf or gives it children.
  void split(const Place& place) {
    BinaryNode& node = nodes_[place.node];
    const std::span<BoxedTriangle> range = triangles_.subspan(node.begin, node.count);
    Bounds bounds, centres;
    for (const BoxedTriangle& each : range) {
      bounds.add(each.bounds);
      centres.add(doubled_centre(each.bounds));
    }
    node.bounds = bounds;
    if (node.count == 1) return;
    const std::optional<Split> best = place.depth < kMostHeuristicDepth ? best_split(range, centres) : std::nullopt;
    const bool may_be_leaf = node.count <= most_in_leaf_;
    if (may_be_leaf && (!best || best->cost + kNodeCost * half_area(bounds) >= half_area(bounds))) return;
    set_children(place.node, best ? partition(range, centres, *best) : node.count / 2);
  }

  void set_children(std::uint32_t node, std::uint32_t left_count) {
    const std::uint32_t begin = nodes_[node].begin;
    // A tree over n triangles has fewer than 2 n nodes, so the left child's fit before the right one.
    nodes_[node].right = node + 2 * left_count;
    set_range(node + 1, begin, left_count);
    set_range(nodes_[node].right, begin + left_count, nodes_[node].count - left_count);
  }

  static int bin_of(float centre, float lower, float bins_per_unit) noexcept {
    return std::clamp(static_cast<int>((centre - lower) * bins_per_unit), 0, kBins - 1);
  }

  // 0 where all centres are in one place, or so close that a reciprocal overflows.
  static glm::vec3 bins_per_unit(const Bounds& centres) noexcept {
    glm::vec3 scale(0);
    for (int axis = 0; axis < 3; ++axis)
      if (const float extent = centres.upper[axis] - centres.lower[axis]; extent > 1e-30f) scale[axis] = kBins / extent;
    return scale;
  }

  std::optional<Split> best_split(std::span<const BoxedTriangle> range, const Bounds& centres) const noexcept {
    std::array<std::array<Bin, kBins>, 3> bins{};
    const glm::vec3 scale = bins_per_unit(centres);
    for (const BoxedTriangle& each : range) {
      const glm::vec3 centre = doubled_centre(each.bounds);
      for (int axis = 0; axis < 3; ++axis) {
        Bin& bin = bins[axis][bin_of(centre[axis], centres.lower[axis], scale[axis])];
        bin.bounds.add(each.bounds);
        ++bin.count;
      }
    }
    std::optional<Split> best;
    for (int axis = 0; axis < 3; ++axis)
      if (scale[axis] > 0) improve(best, bins[axis], axis);
    return best;
  }

  // The cheapest of the planes between bins, if it is cheaper than what was found before.
  void improve(std::optional<Split>& best, const std::array<Bin, kBins>& bins, int axis) const noexcept {
    std::array<float, kBins> right_cost{};
    Bin right;
    for (int i = kBins - 1; i > 0; --i) {
      right.add(bins[i]);
      right_cost[i] = right.count == 0 ? -1 : half_area(right.bounds) * blocks(right.count);
    }
    Bin left;
    for (int i = 1; i < kBins; ++i) {
      left.add(bins[i - 1]);
      if (left.count == 0 || right_cost[i] < 0) continue;
      const float cost = half_area(left.bounds) * blocks(left.count) + right_cost[i];
      if (!best || cost < best->cost) best = {cost, axis, i};
    }
  }

  static std::uint32_t partition(std::span<BoxedTriangle> range, const Bounds& centres, const Split& chosen) {
    const int axis = chosen.axis;
    const float scale = bins_per_unit(centres)[axis];
    const auto middle = std::partition(range.begin(), range.end(), [&](const BoxedTriangle& each) {
      return bin_of(doubled_centre(each.bounds)[axis], centres.lower[axis], scale) < chosen.first_right_bin;
    });
    return static_cast<std::uint32_t>(middle - range.begin());
  }

  std::span<BoxedTriangle> triangles_;
  std::uint32_t most_in_leaf_;
  std::vector<BinaryNode> nodes_;
};

}  // namespace

std::vector<BinaryNode> build_binary_tree(std::span<BoxedTriangle> triangles, int most_in_leaf, Workers& workers) {
  return Builder(triangles, most_in_leaf).build(workers);
}

}  // namespace tuberia::tracer
