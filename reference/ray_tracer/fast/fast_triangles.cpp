#include "reference/ray_tracer/fast/fast_triangles.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "reference/ray_tracer/fast/fast_kernels.hpp"
#include "reference/ray_tracer/fast/widen.hpp"
#include "reference/ray_tracer/shapes/triangle.hpp"

namespace tuberia::tracer {

namespace {

using Corners = std::array<glm::vec3, 3>;

// Squares of larger coordinates are no floats.
constexpr float kLargestCoordinate = 1e18f;

bool is_in_range(const Corners& corners) noexcept {
  for (const glm::vec3& corner : corners)
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(corner[axis]) <= kLargestCoordinate)) return false;
  return true;
}

std::vector<BoxedTriangle> triangles_with_area(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  std::vector<BoxedTriangle> triangles;
  triangles.reserve(indices.size() / 3);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Corners corners{positions[indices[i]], positions[indices[i + 1]], positions[indices[i + 2]]};
    if (!is_in_range(corners) || !has_area({glm::dvec3(corners[0]), glm::dvec3(corners[1]), glm::dvec3(corners[2])})) continue;
    BoxedTriangle& added = triangles.emplace_back();
    for (const glm::vec3& corner : corners) added.bounds.add(corner);
    added.triangle = static_cast<std::uint32_t>(i / 3);
  }
  return triangles;
}

std::optional<Error> find_error(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  if (indices.size() % 3 != 0) return Error{std::to_string(indices.size()) + " indices are no whole number of triangles"};
  if (const auto triangles = static_cast<std::int64_t>(indices.size() / 3); triangles > FastTriangles::kMostTriangles)
    return Error{std::to_string(triangles) + " triangles, but " + std::to_string(FastTriangles::kMostTriangles) + " are the most"};
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (indices[i] >= positions.size())
      return Error{"index " + std::to_string(i) + " is " + std::to_string(indices[i]) + ", but there are " + std::to_string(positions.size()) + " positions"};
  return std::nullopt;
}

}  // namespace

Result<FastTriangles> FastTriangles::create(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices, Workers& workers) {
  const auto start = std::chrono::steady_clock::now();
  if (std::optional<Error> error = find_error(positions, indices)) return *std::move(error);
  auto tree = std::make_unique<WideTree>();
  std::vector<BoxedTriangle> triangles = triangles_with_area(positions, indices);
  if (!triangles.empty()) {
    const std::vector<BinaryNode> binary = build_binary_tree(triangles, kWidth, workers);
    *tree = widen(binary, triangles, positions, indices, workers);
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return FastTriangles(std::move(tree), elapsed.count());
}

FastTriangles::FastTriangles(std::unique_ptr<const WideTree> tree, double build_seconds)
    : tree_(std::move(tree)), kernels_(&fast_kernels().back()), build_seconds_(build_seconds) {}
FastTriangles::~FastTriangles() = default;
FastTriangles::FastTriangles(FastTriangles&&) noexcept = default;
FastTriangles& FastTriangles::operator=(FastTriangles&&) noexcept = default;

FastHit FastTriangles::nearest(const FastRay& ray) const noexcept { return kernels_->nearest(*tree_, ray); }

void FastTriangles::nearest(std::span<const FastRay> rays, std::span<FastHit> hits) const noexcept {
  kernels_->nearest_of_many(*tree_, rays.data(), hits.data(), static_cast<std::int64_t>(std::min(rays.size(), hits.size())));
}

FastFacts FastTriangles::facts() const noexcept {
  const auto bytes = tree_->nodes.size() * sizeof(WideNode) + tree_->blocks.size() * sizeof(TriangleBlock);
  return {.build_seconds = build_seconds_,
          .memory_bytes = static_cast<std::int64_t>(bytes),
          .nodes = static_cast<std::int64_t>(tree_->nodes.size()),
          .blocks = static_cast<std::int64_t>(tree_->blocks.size()),
          .triangles = tree_->triangle_count,
          .instruction_set = kernels_->instruction_set};
}

std::span<const std::string_view> FastTriangles::instruction_sets() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> found;
    for (const FastKernels& each : fast_kernels()) found.push_back(each.instruction_set);
    return found;
  }();
  return names;
}

void FastTriangles::use_instruction_set(std::string_view name) noexcept {
  for (const FastKernels& each : fast_kernels())
    if (each.instruction_set == name) kernels_ = &each;
}

}  // namespace tuberia::tracer
