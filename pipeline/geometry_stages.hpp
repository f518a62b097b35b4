#pragma once
// Stages 1 to 5, and the setup of 6, one after the other on a chunk of primitives. Each stage is
// explained in its own file.

#include "pipeline/chunk.hpp"
#include "pipeline/clipping.hpp"
#include "pipeline/culling.hpp"
#include "pipeline/observer.hpp"
#include "pipeline/perspective_divide.hpp"
#include "pipeline/polygon_modes.hpp"
#include "pipeline/polygon_offset.hpp"
#include "pipeline/primitive_assembly.hpp"
#include "pipeline/rasterization.hpp"
#include "pipeline/shape_set_up.hpp"
#include "pipeline/validate.hpp"
#include "pipeline/vertex_transform.hpp"

namespace tuberia {

class GeometryStages {
 public:
  /// References to the draw and to what it was accepted as must outlive this.
  GeometryStages(const DrawCall& draw, const AcceptedDraw& accepted, InstructionSet instruction_set, Precision precision);

  /// Everything that happens to the primitives of chunk.range until the tiles get them.
  template <class Tap>
  void operator()(Chunk& chunk, const RenderTarget& target, const Tap& tap) const {
    fetch(chunk);
    tap.fetched(chunk);
    vertex_transform_.positions(draw_.mesh, chunk.vertices);      // 1 object -> clip space
    tap.after(Stage::vertex_transform, chunk);
    assemble(chunk);                                              // 2 vertices -> triangles, lines or points
    tap.after(Stage::primitive_assembly, chunk);
    clip(chunk);                                                  // 3 clip -> clip
    tap.after(Stage::clipping, chunk);
    place(chunk.vertices);                                        // 4 clip -> ndc -> screen
    tap.after(Stage::perspective_divide, chunk);
    cull(chunk);                                                  // 5 screen -> screen
    tap.after(Stage::culling, chunk);
    fill_in_attributes(chunk);
    tap.after(Stage::vertex_attributes, chunk);
    set_up(chunk);                                                // 6 screen -> what tiles want
    tap.after(Stage::set_up, chunk);
    rasterization_.bin(chunk.screen_triangles, target.tiles_per_row(), target.tile_rows(), chunk.tiles);
    tap.after(Stage::binning, chunk);
  }

  /// How many primitives the draw has.
  std::int64_t primitives() const noexcept {
    return primitive_count(draw_.state.assembly.topology, static_cast<std::int64_t>(draw_.mesh.element_count()));
  }

  /// How many primitives a chunk of this draw may hold.
  std::int64_t primitives_per_chunk() const noexcept {
    return draw_.state.transform.two_sided_colours ? kTwoSidedPrimitivesPerChunk : kPrimitivesPerChunk;
  }

  /// After all chunks that precede this one: a strip's stipple pattern goes on where it ended.
  std::uint32_t continue_stipple(Chunk& chunk, std::uint32_t start) const noexcept;

 private:
  void fetch(Chunk& chunk) const;
  void assemble(Chunk& chunk) const;
  void clip(Chunk& chunk) const;
  void place(VertexBatch& vertices) const;
  void cull(Chunk& chunk) const;
  void fill_in_attributes(Chunk& chunk) const;
  void set_up(Chunk& chunk) const;

  const DrawCall& draw_;
  const AcceptedDraw& accepted_;
  ClipLimits limits_;
  VertexTransform vertex_transform_;
  PrimitiveAssembly primitive_assembly_;
  Clipping clipping_;
  PerspectiveDivide perspective_divide_;
  Culling culling_;
  PolygonModes polygon_modes_;
  Rasterization rasterization_;
  ShapeSetUp shape_set_up_;
  PolygonOffsetting offset_;
  bool only_fills_;
};

}  // namespace tuberia
