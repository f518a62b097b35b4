#pragma once
// The tree as the kernels read it: eight boxes side by side, eight triangles side by side.       [WideTrees]

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/bounds.hpp"

namespace tuberia::tracer {

inline constexpr int kWidth = 8;

/// Where a child is: the number of a node, or of a block of triangles.
struct ChildReference {
  static constexpr std::uint32_t kBlock = 0x80000000;

  std::uint32_t code = 0;

  static ChildReference node(std::uint32_t number) noexcept { return {number}; }
  static ChildReference block(std::uint32_t number) noexcept { return {number | kBlock}; }
  bool is_block() const noexcept { return (code & kBlock) != 0; }
  std::uint32_t number() const noexcept { return code & ~kBlock; }
};

/// Six planes of each child: lower x, y, z, upper x, y, z. Boxes are exact: corners are floats. Places without a
/// child have a box that is empty, inside out.
struct alignas(32) WideNode {
  float planes[6 * kWidth];
  ChildReference child[kWidth];
};

/// Corners by vertex and axis, world space. Places without a triangle have NaNs, which no ray meets.
struct alignas(32) TriangleBlock {
  float corner[3][3][kWidth];
  float size[kWidth];  // the longest side of the triangle's box
  std::uint32_t triangle[kWidth];
};

/// Of the binary tree: 28 levels more than those that the surface area heuristic may use.
inline constexpr int kMostHeuristicDepth = 64, kMostDepth = kMostHeuristicDepth + 28;
/// Of children that a ray has yet to visit. A level of the wide tree is at least one of the binary tree.
inline constexpr int kMostWaiting = kMostDepth * (kWidth - 1) + 1;

/// Node 0 is the root; there is none without triangles.
struct WideTree {
  std::vector<WideNode> nodes;
  std::vector<TriangleBlock> blocks;
  Bounds bounds;  // of all triangles
  std::int64_t triangle_count = 0;
};

}  // namespace tuberia::tracer
