#pragma once
// A fragment program as the pipeline sees it: what it reads, and its tile loops.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "base/result.hpp"
#include "raster/attributes.hpp"
#include "raster/fragment_block.hpp"
#include "raster/instruction_set.hpp"
#include "raster/tile.hpp"
#include "raster/tile_visibility.hpp"

namespace tuberia {

using Refusal = std::optional<Error>;  // empty: nothing is wrong

/// A program may refuse in a fixed sentence, or null, as well.
inline Refusal as_refusal(Refusal refusal) { return refusal; }
inline Refusal as_refusal(const char* sentence) { return sentence != nullptr ? Refusal(Error{sentence}) : Refusal(); }

/// All that a tile loop needs beside its tile.
struct FragmentJob {
  OutputState output;
  const void* uniforms = nullptr;
  bool flat_shading = false;
  DrawOrder order = DrawOrder::as_submitted;  // last_first: only if is_order_free(output)
};

/// One program compiled for one instruction set and precision.
struct ProgramKernels {
  /// Draws the listed triangles of a chunk into a tile, in the job's order: coverage, interpolation,
  /// depth, program and blending fused into one loop. What is hidden is left out.
  void (*draw_tile)(const FragmentJob&, const Tile&, TileVisibility&, const ChunkView&, std::span<const std::uint16_t> triangles);
  /// Only the program: colours of the live fragments; clears the live bits of discarded ones.
  void (*shade)(const FragmentJob&, const ChunkView&, FragmentBlock&);
};

/// What every instance of a program has in common.
struct ProgramInterface {
  std::string_view name;
  Attributes interpolated = Attributes::none;  // over the triangle
  Attributes flat = Attributes::none;          // as at its first vertex
  const ProgramKernels& (*kernels)(InstructionSet, Precision) = nullptr;
  bool may_discard = false;
  bool has_ingredients = false;  // kernels for each ingredient of Precision::fast alone
  Refusal (*refusal)(const void* uniforms) = nullptr;  // why these cannot be drawn with; empty if they can

  constexpr Attributes attributes() const noexcept { return interpolated | flat; }
};

/// Whether the depth test may come before the program: nothing after it drops a fragment.
constexpr bool tests_depth_early(const ProgramInterface& program, const OutputState& output) noexcept {
  return !program.may_discard && output.alpha_test.test == Compare::always && !output.multisampling.alpha_to_coverage;
}

/// Whether fragments get a colour at all: it is stored, or decides whether they are dropped.
constexpr bool shades(const ProgramInterface& program, const OutputState& output) noexcept {
  return output.blend.write || !tests_depth_early(program, output);
}

/// A program with its uniforms; cheap to copy.
class FragmentProgram {
 public:
  FragmentProgram() = default;
  template <class Uniforms>
  FragmentProgram(const ProgramInterface& interface, Uniforms uniforms)
      : interface_(&interface), uniforms_(std::make_shared<const Uniforms>(std::move(uniforms))) {}

  bool is_set() const noexcept { return interface_ != nullptr; }
  const ProgramInterface& interface() const noexcept { return *interface_; }
  const void* uniforms() const noexcept { return uniforms_.get(); }

 private:
  const ProgramInterface* interface_ = nullptr;
  std::shared_ptr<const void> uniforms_;
};

}  // namespace tuberia
