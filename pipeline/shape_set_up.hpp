#pragma once
// Setup of points and lines: the records that tiles want of them, in among the triangles'.

#include <vector>

#include "pipeline/chunk.hpp"
#include "pipeline/state.hpp"

namespace tuberia {

class ShapeSetUp {
 public:
  /// samples: of each pixel; lines are as wide as a whole number of pixels where there is one.
  ShapeSetUp(const RasterizationState& state, int samples) noexcept;

  /// Adds the chunk's lines and points to its screen triangles, all in the order of their primitives,
  /// and fills chunk.shapes. Lines that do not begin the pattern go on from their predecessor, the
  /// chunk's first from 0; chunk.stipple_advance is where its last one ends.
  void operator()(Chunk& chunk) const;

 private:
  ScreenShape line_shape(const VertexBatch& vertices, const AssembledLine& line) const;
  ScreenShape point_shape(const VertexBatch& vertices, const AssembledPoint& point) const;

  bool round_points_;
  std::int32_t point_size_, line_size_;  // units
  std::uint32_t pattern_period_;         // pixels until a stipple pattern comes round
};

/// Lets a strip's pattern go on from one chunk to the next: adds `start` to the chunk's lines and
/// returns where the next chunk's begin.
std::uint32_t continue_pattern(Chunk& chunk, std::uint32_t start, const StipplePattern& pattern) noexcept;

}  // namespace tuberia
