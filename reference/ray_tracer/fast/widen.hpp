#pragma once
// From a binary tree to one of eight children a node.

#include <glm/vec3.hpp>
#include <span>

#include "reference/ray_tracer/fast/binary_tree.hpp"
#include "reference/ray_tracer/fast/wide_tree.hpp"

namespace tuberia::tracer {

/// Leaves have at most kWidth triangles.
WideTree widen(std::span<const BinaryNode> binary, std::span<const BoxedTriangle> triangles, std::span<const glm::vec3> positions,
               std::span<const std::uint32_t> indices, Workers& workers);

}  // namespace tuberia::tracer
