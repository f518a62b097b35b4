#include "reference/ray_tracer/accelerators/bvh.hpp"

#include <array>
#include <utility>

#include "reference/ray_tracer/accelerators/slabs.hpp"

namespace tuberia::tracer {

Bvh::Bvh(const Items& items, Workers& workers, const AcceleratorSettings& settings) : SearchingAccelerator(items) {
  BoxedItems boxed = boxes_of(items, workers);
  largest_coordinate_ = boxed.largest_coordinate;
  set_unbounded(std::move(boxed.unbounded));
  tree_ = build_bvh(std::move(boxed.bounded), workers, settings);
  facts_.memory_bytes = unbounded_bytes();
  facts_.memory_bytes += static_cast<std::int64_t>(tree_.nodes.capacity() * sizeof(BvhNode) + tree_.items.capacity() * sizeof(std::uint32_t));
  facts_.volumes = static_cast<std::int64_t>(tree_.nodes.size());
  facts_.depth = tree_.depth;
}

void Bvh::search(Search& search) const noexcept {
  struct Waiting {
    std::uint32_t node;
    double entry;
  };
  std::array<Waiting, kDeepestBvh> waiting;  // one for each level above the present node at most
  std::size_t waiting_count = 0;
  const Slabs slabs(search.ray(), largest_coordinate_);
  const auto entry_of = [&](std::uint32_t node) {
    search.count_volume();
    return slabs.entry(tree_.nodes[node].box, search.limit());
  };
  if (tree_.nodes.empty() || entry_of(0) == kInfinity) return;

  for (std::uint32_t current = 0;;) {
    const BvhNode& node = tree_.nodes[current];
    if (node.count == 0) {
      // The nearer of the two goes on, the farther waits.
      Waiting nearer{node.first, entry_of(node.first)}, farther{node.first + 1, entry_of(node.first + 1)};
      if (farther.entry < nearer.entry) std::swap(nearer, farther);
      if (farther.entry < kInfinity) waiting[waiting_count++] = farther;
      if (nearer.entry < kInfinity) {
        current = nearer.node;
        continue;
      }
    } else {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        search.ask(tree_.items[i]);
        if (search.is_over()) return;
      }
    }
    // Those behind what was found meanwhile are not needed any more.
    do {
      if (waiting_count == 0) return;
      --waiting_count;
    } while (waiting[waiting_count].entry > search.limit());
    current = waiting[waiting_count].node;
  }
}

}  // namespace tuberia::tracer
