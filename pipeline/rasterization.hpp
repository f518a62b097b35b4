#pragma once
// Stage 6: screen triangles to fragments, an 8x8 block at a time.

#include <vector>

#include "pipeline/state.hpp"
#include "pipeline/vertex_batch.hpp"
#include "raster/binning.hpp"
#include "raster/fragment_block.hpp"
#include "raster/render_target.hpp"

namespace tuberia {

class Rasterization {
 public:
  /// clip: the pixels that may be drawn; samples: of each; edges: exact where there are several.
  Rasterization(const PixelRect& clip, InstructionSet instruction_set, Precision precision, int samples = 1,
                EdgeArithmetic edges = EdgeArithmetic::exact) noexcept
      : clip_(clip), has_samples_(samples > 1), edges_(edges), geometry_(geometry_kernels(instruction_set)), blocks_(block_kernels(instruction_set, precision)) {}

  /// Edge functions, depth and 1/w of each triangle, by exact arithmetic on snapped vertices.
  void set_up(TriangleBatch& triangles, const VertexBatch& vertices, std::vector<ScreenTriangle>& out) const;

  /// Lets triangles that would divide at each pixel do so more rarely.
  static void choose_perspective(PerspectiveCorrection correction, std::span<ScreenTriangle> records) noexcept;

  /// Lets what is turned away find its own colours, where faces have them.
  static void choose_faces(const VertexBatch& vertices, std::span<ScreenTriangle> records) noexcept;

  /// What the tiles want to know of each triangle before they look at it.
  static void measure(std::span<const ScreenTriangle> records, std::vector<TriangleExtent>& out);

  /// Sorts triangles into the tiles of a target.
  void bin(std::span<const ScreenTriangle> triangles, int tiles_per_row, int tile_rows, TileLists& out) const {
    out.build(triangles, clip_, tiles_per_row, tile_rows, has_samples_ || edges_ != EdgeArithmetic::exact ? 0.5 : 0.0);
  }

  /// The blocks of fragments of one triangle on a target, tile by tile. The tile loops do the same
  /// without writing blocks to memory. The triangle must outlive the blocks.       [C 4.2] [rules R2, R3]
  std::vector<FragmentBlock> blocks(const ScreenTriangle& triangle, RenderTarget& target) const;

 private:
  PixelRect clip_;
  bool has_samples_;   // which lie up to half a pixel beside the centre
  EdgeArithmetic edges_;  // rounding moves them by much less
  const GeometryKernels& geometry_;
  const BlockKernels& blocks_;
};

}  // namespace tuberia
