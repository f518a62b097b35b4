#pragma once
// A hierarchy of boxes in boxes, two in each.                                      [KayKajiya]

#include <cstdint>
#include <vector>

#include "reference/ray_tracer/accelerators/search.hpp"

namespace tuberia::tracer {

/// count = 0: the boxes in it are nodes[first] and nodes[first + 1]. Otherwise a leaf: items[first, first + count).
struct alignas(64) BvhNode {
  Box box;
  std::uint32_t first = 0, count = 0;
};

/// The root is nodes[0]; no nodes if there are no items.
struct BvhTree {
  std::vector<BvhNode> nodes;
  std::vector<std::uint32_t> items;
  int depth = 0;  // of the deepest node, the root's is 1; kDeepestBvh at most
};

inline constexpr int kDeepestBvh = 96;

/// Split where the surface area heuristic says, on bins of the items' centres; the same tree for any number of workers.
BvhTree build_bvh(std::vector<BoxedItem> items, Workers& workers, const AcceleratorSettings& settings);

class Bvh final : public SearchingAccelerator {
 public:
  Bvh(const Items& items, Workers& workers, const AcceleratorSettings& settings);

 private:
  void search(Search& search) const noexcept override;

  BvhTree tree_;
  double largest_coordinate_ = 0;
};

}  // namespace tuberia::tracer
