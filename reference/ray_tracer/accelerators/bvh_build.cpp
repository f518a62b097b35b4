// Building the hierarchy from the top: the upper levels with all workers on one box, the lower ones with a worker
// for each subtree. What is split where depends on the items alone.                        [Wald]

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "reference/ray_tracer/accelerators/bvh.hpp"

namespace tuberia::tracer {
namespace {

constexpr int kBins = 16;
// What asking a pair of boxes costs, in tests of items.
constexpr double kPairCost = 1.0;
// Lopsided trees end here: from then on items are halved, which 32 bits allow 32 times.
constexpr int kMostBinnedDepth = kDeepestBvh - 33;
// Fewer are binned by one worker: handing out smaller chunks costs more than it gives.
constexpr std::int64_t kChunk = 16384;

glm::dvec3 centre_of(const BoxedItem& item) noexcept { return item.box.centre(); }

int longest_axis(const glm::dvec3& size) noexcept { return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2; }

struct Extent {
  Box items, centres;
  void add(const BoxedItem& item) noexcept {
    items.add(item.box);
    centres.add(centre_of(item));
  }
  void add(const Extent& other) noexcept {
    items.add(other.items);
    centres.add(other.centres);
  }
};

/// Equal parts of the centres' extent along each axis.
class Bins {
 public:
  explicit Bins(const Box& centres) noexcept : lower_(centres.lower), per_unit_(double{kBins} / centres.size()) {}

  int bin_of(const BoxedItem& item, int axis) const noexcept {
    const double at = (centre_of(item)[axis] - lower_[axis]) * per_unit_[axis];
    return at < kBins ? static_cast<int>(at) : kBins - 1;  // also what is no number, where the extent is 0
  }
  void add(const BoxedItem& item) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
      Bin& bin = bins_[axis][bin_of(item, axis)];
      bin.box.add(item.box);
      ++bin.count;
    }
  }
  void add(const Bins& other) noexcept {
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < kBins; ++i) {
        bins_[axis][i].box.add(other.bins_[axis][i].box);
        bins_[axis][i].count += other.bins_[axis][i].count;
      }
  }

  /// The first bin of the upper part; cost: the items on each side times its area, not yet divided by the whole's.
  struct Split {
    int axis = 0, bin = 0;
    double cost = kInfinity;
  };
  Split cheapest() const noexcept {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      std::array<double, kBins> upper_cost{};
      Box box;
      std::int64_t count = 0;
      for (int i = kBins - 1; i > 0; --i) {
        box.add(bins_[axis][i].box);
        count += bins_[axis][i].count;
        upper_cost[i] = count == 0 ? kInfinity : static_cast<double>(count) * box.half_area();
      }
      box = {};
      count = 0;
      for (int i = 1; i < kBins; ++i) {
        box.add(bins_[axis][i - 1].box);
        count += bins_[axis][i - 1].count;
        if (count == 0) continue;
        if (const double cost = static_cast<double>(count) * box.half_area() + upper_cost[i]; cost < best.cost) best = {axis, i, cost};
      }
    }
    return best;
  }

 private:
  struct Bin {
    Box box;
    std::int64_t count = 0;
  };
  std::array<std::array<Bin, kBins>, 3> bins_{};
  glm::dvec3 lower_, per_unit_;
};

/// The sum of items' contributions to an empty Sum; with workers if there are any to help. Sums must be exact, so
/// that the chunks do not matter.
template <class Sum>
Sum sum_of(std::span<const BoxedItem> items, Workers* workers, const Sum& empty) {
  const auto count = static_cast<std::int64_t>(items.size());
  const auto add_chunk = [&](Sum& sum, std::int64_t chunk) {
    for (const BoxedItem& item : items.subspan(chunk * kChunk, std::min(kChunk, count - chunk * kChunk))) sum.add(item);
  };
  const std::int64_t chunks = (count + kChunk - 1) / kChunk;
  Sum sum = empty;
  if (workers == nullptr) {
    for (std::int64_t chunk = 0; chunk < chunks; ++chunk) add_chunk(sum, chunk);
    return sum;
  }
  std::vector<Sum> of_worker(static_cast<std::size_t>(workers->thread_count()), empty);
  parallel_for(*workers, chunks, [&](std::int64_t chunk, int worker) { add_chunk(of_worker[static_cast<std::size_t>(worker)], chunk); });
  for (const Sum& each : of_worker) sum.add(each);
  return sum;
}

/// items[first, first + count) and the node that is to hold them.
struct Part {
  std::uint32_t node = 0;
  std::size_t first = 0, count = 0;
  int depth = 1;
};

class Builder {
 public:
  Builder(std::span<BoxedItem> items, Workers* workers, const AcceleratorSettings& settings)
      : items_(items), workers_(workers), most_items_(static_cast<std::size_t>(std::max(settings.most_items, 1))) {}

  /// Appends to `nodes`, whose node part.node is there already. Parts of no more than `small` items are left to others.
  std::vector<Part> build(const Part& root, std::size_t small, std::vector<BvhNode>& nodes) {
    std::vector<Part> open{root}, left;
    while (!open.empty()) {
      const Part part = open.back();
      open.pop_back();
      if (part.count <= small) {
        left.push_back(part);
        continue;
      }
      deepest_ = std::max(deepest_, part.depth);
      const std::span<BoxedItem> items = items_.subspan(part.first, part.count);
      const Extent extent = sum_of(std::span<const BoxedItem>(items), workers_, Extent{});
      const std::size_t lower_count = split(items, extent, part.depth);
      nodes[part.node].box = extent.items;
      if (lower_count == 0) {
        nodes[part.node].first = static_cast<std::uint32_t>(part.first);
        nodes[part.node].count = static_cast<std::uint32_t>(part.count);
        continue;
      }
      const auto pair = static_cast<std::uint32_t>(nodes.size());
      nodes[part.node].first = pair;
      nodes.resize(nodes.size() + 2);
      open.push_back({pair + 1, part.first + lower_count, part.count - lower_count, part.depth + 1});
      open.push_back({pair, part.first, lower_count, part.depth + 1});
    }
    return left;
  }

  int deepest() const noexcept { return deepest_; }

 private:
  /// Reorders the items; returns how many come into the first half, 0 for a leaf.
  std::size_t split(std::span<BoxedItem> items, const Extent& extent, int depth) {
    if (items.size() == 1) return 0;
    const glm::dvec3 spread = extent.centres.size();
    if (spread == glm::dvec3(0)) return split_by_size(items);
    const double area = extent.items.half_area();
    if (depth >= kMostBinnedDepth || !(area > 0)) return items.size() <= most_items_ ? 0 : split_in_half(items, longest_axis(spread));

    const Bins bins = sum_of(std::span<const BoxedItem>(items), workers_, Bins(extent.centres));
    const Bins::Split best = bins.cheapest();
    const bool is_cheaper = kPairCost * area + best.cost < static_cast<double>(items.size()) * area;
    if (items.size() <= most_items_ && !is_cheaper) return 0;
    if (!(best.cost < kInfinity)) return split_in_half(items, longest_axis(spread));
    const auto upper = std::partition(items.begin(), items.end(), [&](const BoxedItem& item) { return bins.bin_of(item, best.axis) < best.bin; });
    return static_cast<std::size_t>(upper - items.begin());
  }

  static std::size_t split_in_half(std::span<BoxedItem> items, int axis) {
    const auto middle = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
    std::nth_element(items.begin(), middle, items.end(), [axis](const BoxedItem& a, const BoxedItem& b) {
      return std::pair(centre_of(a)[axis], a.item) < std::pair(centre_of(b)[axis], b.item);
    });
    return items.size() / 2;
  }

  /// Of items around one centre the large ones hide the small ones. Equal ones stay together.
  std::size_t split_by_size(std::span<BoxedItem> items) const {
    if (items.size() <= most_items_) return 0;
    const auto smaller = [](const BoxedItem& a, const BoxedItem& b) { return std::pair(a.box.half_area(), a.item) < std::pair(b.box.half_area(), b.item); };
    const auto [least, most] = std::minmax_element(items.begin(), items.end(), smaller);
    if (least->box == most->box) return 0;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2), items.end(), smaller);
    return items.size() / 2;
  }

  std::span<BoxedItem> items_;
  Workers* workers_;
  std::size_t most_items_;
  int deepest_ = 0;
};

struct Subtree {
  Part part;
  std::vector<BvhNode> nodes;
  int depth = 0;
};

/// Its root takes the place that was kept for it, the others are appended.
void graft(const Subtree& subtree, std::vector<BvhNode>& nodes) {
  const auto offset = static_cast<std::uint32_t>(nodes.size()) - 1;
  const auto moved = [offset](BvhNode node) {
    if (node.count == 0) node.first += offset;
    return node;
  };
  nodes[subtree.part.node] = moved(subtree.nodes[0]);
  for (std::size_t i = 1; i < subtree.nodes.size(); ++i) nodes.push_back(moved(subtree.nodes[i]));
}

}  // namespace

BvhTree build_bvh(std::vector<BoxedItem> items, Workers& workers, const AcceleratorSettings& settings) {
  constexpr std::size_t kFewest = 1024, kSubtrees = 64;
  BvhTree tree;
  if (items.empty()) return tree;

  // The top, until the parts are many and small enough to be handed out.
  tree.nodes.resize(1);
  Builder top(items, &workers, settings);
  std::vector<Subtree> subtrees;
  const std::size_t small = std::max(kFewest, items.size() / kSubtrees);
  for (const Part& part : top.build({.count = items.size()}, small, tree.nodes)) subtrees.push_back({part, std::vector<BvhNode>(1)});

  // Each worker owns the items of the parts that it builds.
  parallel_for(workers, static_cast<std::int64_t>(subtrees.size()), [&](std::int64_t i, int) {
    Subtree& subtree = subtrees[static_cast<std::size_t>(i)];
    Builder builder(items, nullptr, settings);
    Part root = subtree.part;
    root.node = 0;
    builder.build(root, 0, subtree.nodes);
    subtree.depth = builder.deepest();
  });

  tree.depth = top.deepest();
  std::size_t node_count = tree.nodes.size();
  for (const Subtree& subtree : subtrees) node_count += subtree.nodes.size() - 1;
  tree.nodes.reserve(node_count);
  for (const Subtree& subtree : subtrees) {
    graft(subtree, tree.nodes);
    tree.depth = std::max(tree.depth, subtree.depth);
  }
  tree.items.reserve(items.size());
  for (const BoxedItem& item : items) tree.items.push_back(item.item);
  return tree;
}

}  // namespace tuberia::tracer
