#pragma once
// A binary tree of boxes by the surface area heuristic, in bins, in parallel.            [Wald]

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "base/parallel_for.hpp"
#include "scene/bounds.hpp"

namespace tuberia::tracer {

/// A triangle as the tree's builder sees it.
struct BoxedTriangle {
  Bounds bounds;
  std::uint32_t triangle;
};

/// The triangles [begin, begin + count) of the ordered list. Of an inner node the left child follows at once.
struct BinaryNode {
  Bounds bounds;
  std::uint32_t begin = 0, count = 0;
  std::uint32_t right = 0;  // the right child's number; 0: a leaf

  bool is_leaf() const noexcept { return right == 0; }
};

/// Orders the triangles so that those of a node are neighbours. Leaves have up to `most_in_leaf` triangles, which one test
/// takes together; no leaf is deeper than kMostDepth. Numbers of nodes have gaps; node 0 is the root. The same tree for any
/// number of workers. There is at least one triangle.
std::vector<BinaryNode> build_binary_tree(std::span<BoxedTriangle> triangles, int most_in_leaf, Workers& workers);

}  // namespace tuberia::tracer
