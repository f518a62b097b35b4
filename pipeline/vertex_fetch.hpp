#pragma once
// Which vertices a chunk needs: indices to slots, so that a vertex is transformed once although
// several triangles use it.

#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/draw_call.hpp"
#include "pipeline/vertex_batch.hpp"

namespace tuberia {

/// A run of a draw's primitives.
struct PrimitiveRange {
  std::int64_t first = 0;
  int count = 0;
};

/// How many primitives `elements` vertices make.
std::int64_t primitive_count(Topology topology, std::int64_t elements) noexcept;

class VertexFetch {
 public:
  /// Fills batch.source with the vertices of the range, and slots with the slot of each element in
  /// the order primitive assembly wants them. A fan's first vertex comes first.
  void operator()(const MeshView& mesh, Topology topology, PrimitiveRange range, VertexBatch& batch,
                  std::vector<std::uint32_t>& slots);

 private:
  // Direct-mapped: a mesh in any sensible order finds its vertices here, and one that does not
  // only transforms some twice.
  static constexpr std::size_t kEntries = 4096;
  struct Entry {
    std::uint32_t vertex, slot;
  };
  std::array<Entry, kEntries> cache_;
  std::vector<std::uint32_t> source_;  // room for what batch.source gets
};

}  // namespace tuberia
