#pragma once
// Stage 2: vertices to triangles, lines or points.

#include <span>

#include "pipeline/state.hpp"
#include "pipeline/vertex_batch.hpp"
#include "pipeline/vertex_fetch.hpp"

namespace tuberia {

class PrimitiveAssembly {
 public:
  explicit PrimitiveAssembly(const AssemblyState& state) noexcept : topology_(state.topology) {}

  /// Joins the slots of a range's elements, as VertexFetch lists them. Every triangle keeps the
  /// winding of its list, strip or fan; its first vertex there is the
  /// provoking one; a fan's is the earlier of the two on the rim, not the hub.   [C 3.6]
  void operator()(std::span<const std::uint32_t> slots, PrimitiveRange range, TriangleBatch& out) const;

  /// Lines of a list, a strip or a loop; each from its first vertex, the provoking one, to its second.
  void operator()(std::span<const std::uint32_t> slots, PrimitiveRange range, LineBatch& out) const;

  /// A point for every element.
  void operator()(std::span<const std::uint32_t> slots, PrimitiveRange range, PointBatch& out) const;

 private:
  Topology topology_;
};

}  // namespace tuberia
