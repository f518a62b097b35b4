#include "reference/ray_tracer/fast/widen.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace tuberia::tracer {

namespace {

float half_area_of(const Bounds& box) noexcept {
  const glm::vec3 size = box.upper - box.lower;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

// The binary nodes that become children of one wide node.
struct Children {
  std::array<std::uint32_t, kWidth> node{};
  int count = 0;
};

// The largest inner child gives way to its two children as long as there is room: the box that most rays meet is
// tested the least.
Children children_of(std::span<const BinaryNode> binary, std::uint32_t parent) {
  Children children;
  children.node[children.count++] = parent;
  while (children.count < kWidth) {
    int largest = -1;
    float largest_area = -1;
    for (int i = 0; i < children.count; ++i) {
      const BinaryNode& each = binary[children.node[i]];
      if (each.is_leaf() || half_area_of(each.bounds) <= largest_area) continue;
      largest = i;
      largest_area = half_area_of(each.bounds);
    }
    if (largest < 0) break;
    const std::uint32_t opened = children.node[largest];
    children.node[largest] = opened + 1;
    children.node[children.count++] = binary[opened].right;
  }
  return children;
}

void set_box(WideNode& node, int place, const Bounds& box) {
  for (int axis = 0; axis < 3; ++axis) {
    node.planes[axis * kWidth + place] = box.lower[axis];
    node.planes[(3 + axis) * kWidth + place] = box.upper[axis];
  }
}

// Numbers follow the order in which children are met first, so that what rays read together lies together.
class Widening {
 public:
  Widening(std::span<const BinaryNode> binary, WideTree& tree) : binary_(binary), tree_(tree) {}

  std::uint32_t add_node(std::uint32_t parent) {
    const auto number = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes.emplace_back();
    const Children children = children_of(binary_, parent);
    for (int place = 0; place < kWidth; ++place)
      set_box(tree_.nodes[number], place, place < children.count ? binary_[children.node[place]].bounds : Bounds{});
    for (int place = 0; place < children.count; ++place) {
      const std::uint32_t child = children.node[place];
      if (!binary_[child].is_leaf()) continue;
      tree_.nodes[number].child[place] = ChildReference::block(static_cast<std::uint32_t>(leaves.size()));
      leaves.push_back(child);
    }
    for (int place = 0; place < children.count; ++place) {
      if (binary_[children.node[place]].is_leaf()) continue;
      const std::uint32_t child = add_node(children.node[place]);
      tree_.nodes[number].child[place] = ChildReference::node(child);
    }
    return number;
  }

  std::vector<std::uint32_t> leaves;  // by block

 private:
  std::span<const BinaryNode> binary_;
  WideTree& tree_;
};

void fill_block(TriangleBlock& block, std::span<const BoxedTriangle> triangles, std::span<const glm::vec3> positions,
                std::span<const std::uint32_t> indices) {
  for (std::size_t place = 0; place < kWidth; ++place) {
    const bool is_used = place < triangles.size();
    const std::uint32_t triangle = is_used ? triangles[place].triangle : 0;
    block.triangle[place] = triangle;
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
      for (int axis = 0; axis < 3; ++axis)
        block.corner[vertex][axis][place] =
            is_used ? positions[indices[3 * std::size_t{triangle} + vertex]][axis] : std::numeric_limits<float>::quiet_NaN();
    const glm::vec3 size = is_used ? triangles[place].bounds.upper - triangles[place].bounds.lower : glm::vec3(0);
    block.size[place] = std::max({size.x, size.y, size.z});
  }
}

}  // namespace

WideTree widen(std::span<const BinaryNode> binary, std::span<const BoxedTriangle> triangles, std::span<const glm::vec3> positions,
               std::span<const std::uint32_t> indices, Workers& workers) {
  WideTree tree;
  tree.bounds = binary[0].bounds;
  tree.triangle_count = static_cast<std::int64_t>(triangles.size());
  Widening widening(binary, tree);
  widening.add_node(0);

  tree.blocks.resize(widening.leaves.size());
  constexpr std::int64_t kBlocksPerTask = 1024;
  const auto count = static_cast<std::int64_t>(tree.blocks.size());
  parallel_for(workers, (count + kBlocksPerTask - 1) / kBlocksPerTask, [&](std::int64_t task, int) {
    for (std::int64_t i = task * kBlocksPerTask; i < std::min(count, (task + 1) * kBlocksPerTask); ++i) {
      const BinaryNode& leaf = binary[widening.leaves[i]];
      fill_block(tree.blocks[i], triangles.subspan(leaf.begin, leaf.count), positions, indices);
    }
  });
  return tree;
}

}  // namespace tuberia::tracer
