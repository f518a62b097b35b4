#pragma once
// The nearest of many triangles, fast: floats say what a ray cannot meet, doubles what it does.

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <span>
#include <string_view>

#include "base/parallel_for.hpp"
#include "base/result.hpp"

namespace tuberia::tracer {

struct FastKernels;
struct WideTree;

/// r(t) = O + t D [B 5-1], world space. Triangles are met where t_min < t < t_max; t counts in D's length, which may be any
/// but 0. A ray meets nothing if one of its numbers is NaN, if any but t_max is infinite, if D is 0 or t_min >= t_max.
struct FastRay {
  glm::vec3 origin{0, 0, 0};
  float t_min = 0;
  glm::vec3 direction{0, 0, -1};
  float t_max = std::numeric_limits<float>::infinity();
};

/// What a ray meets first. The point is (1 - u - v) a + u b + v c of the triangle a, b, c.
struct FastHit {
  static constexpr std::uint32_t kNothing = 0xffffffff;

  float t = std::numeric_limits<float>::infinity();
  std::uint32_t triangle = kNothing;  // its three indices begin at 3 * triangle
  float u = 0, v = 0;

  explicit operator bool() const noexcept { return triangle != kNothing; }
  bool operator==(const FastHit&) const = default;
};

/// What it cost.
struct FastFacts {
  double build_seconds = 0;
  std::int64_t memory_bytes = 0;
  std::int64_t nodes = 0, blocks = 0;    // of up to 8 children, of up to 8 triangles
  std::int64_t triangles = 0;            // that have an area
  std::string_view instruction_set;      // "sse4", "avx2", "avx3", ...
};

/// Triangles in a tree of eight children a node [WideTrees]. A hit is what Woop's test says in doubles [Woop] of the triangles as
/// they are in floats: no ray passes between two triangles that share an edge. t and u, v are that test's, rounded to
/// float; of triangles at the same t in doubles the smallest number wins. The same bits from every instruction set, for any
/// number of workers, for one ray and for many. Rays from further away than 2^40 times the triangles' box are not sound enough: they meet nothing.
class FastTriangles {
 public:
  static constexpr std::int64_t kMostTriangles = 1 << 28;

  /// Three indices a triangle, positions in world space. Triangles without an area and those with corners that are not finite or
  /// beyond 1e18 are never met. Errors: an index beyond the positions, indices not in threes, too many.
  static Result<FastTriangles> create(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices, Workers& workers);

  ~FastTriangles();
  FastTriangles(FastTriangles&&) noexcept;
  FastTriangles& operator=(FastTriangles&&) noexcept;

  FastHit nearest(const FastRay& ray) const noexcept;

  /// The same of each ray; as many hits as rays. Quicker where neighbours go much the same way: 16 rays at a time.
  void nearest(std::span<const FastRay> rays, std::span<FastHit> hits) const noexcept;

  FastFacts facts() const noexcept;

  /// Those that this machine has, narrowest first; the last is what triangles start with.
  static std::span<const std::string_view> instruction_sets();
  /// For tests and measurements; nothing changes if there is no such set.
  void use_instruction_set(std::string_view name) noexcept;

 private:
  FastTriangles(std::unique_ptr<const WideTree> tree, double build_seconds);

  std::unique_ptr<const WideTree> tree_;
  const FastKernels* kernels_;
  double build_seconds_;
};

}  // namespace tuberia::tracer
