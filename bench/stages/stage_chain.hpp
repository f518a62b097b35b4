#pragma once
// What the stages are measured on: a jittered grid of triangles under a perspective projection, and
// the chain of stages that brings it to the one that is measured.

#include <optional>
#include <vector>

#include "pipeline/chunk.hpp"
#include "pipeline/clipping.hpp"
#include "pipeline/culling.hpp"
#include "pipeline/perspective_divide.hpp"
#include "pipeline/primitive_assembly.hpp"
#include "pipeline/programs/programs.hpp"
#include "pipeline/rasterization.hpp"
#include "pipeline/validate.hpp"
#include "pipeline/vertex_transform.hpp"

namespace tuberia::bench {

/// Which triangles of a grid cross the near plane.
enum class Crossing { none, one, all };

/// A square grid of quads that fills a square target.
struct GridShape {
  int quads_per_side = 32;
  int target_pixels = 256;  // per side
  Crossing crossing = Crossing::none;

  std::size_t triangles() const noexcept { return 2u * static_cast<std::size_t>(quads_per_side * quads_per_side); }
  std::size_t vertices() const noexcept { return static_cast<std::size_t>((quads_per_side + 1) * (quads_per_side + 1)); }
};

inline constexpr GridShape kSmallTriangles{};  // one chunk: 2048 triangles of 32 pixels
inline constexpr GridShape kLargeTriangles{.quads_per_side = 2, .target_pixels = 512};  // 8 of 32768 pixels
inline constexpr const char* kSmallName = "32_pixels";
inline constexpr const char* kLargeName = "32768_pixels";

/// A draw of a grid, in plain words.
struct StageSubject {
  GridShape grid;
  FragmentProgram program = gouraud();
  std::optional<Lighting> vertex_lighting{};
  CullFace cull = CullFace::none;  // the front is what the grid shows
  ColourFormat colour_format = ColourFormat::rgba8;
};

/// The geometry stages in their order.
enum class Stage { vertex_fetch, positions, primitive_assembly, clipping, perspective_divide, culling, attributes, set_up, bin };

struct GridMesh {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> texcoords;
  std::vector<glm::vec4> colours;
  std::vector<std::uint32_t> indices;
};

/// The stages of one draw and its only chunk. Not copied: the draw refers to the mesh beside it.
struct StageChain {
  explicit StageChain(const StageSubject& subject, InstructionSet isa = best_instruction_set(),
                      Precision precision = Precision::exact);
  StageChain(const StageChain&) = delete;
  StageChain& operator=(const StageChain&) = delete;

  /// Runs the geometry stages on the whole grid, up to `last`, which is included.
  void run_through(Stage last);

  /// After the last stage: at most this many blocks of fragments, taken evenly from all.
  std::vector<FragmentBlock> some_blocks(std::size_t most);

  GridMesh mesh;
  DrawCall draw;
  RenderTarget target;
  AcceptedDraw accepted;
  ClipLimits limits;
  VertexTransform vertex_transform;
  PrimitiveAssembly primitive_assembly;
  Clipping clipping;
  PerspectiveDivide perspective_divide;
  Culling culling;
  Rasterization rasterization;
  const BlockKernels& blocks;
  Chunk chunk;
};

/// How many fragments are live in all.
std::size_t live_fragments(const std::vector<FragmentBlock>& blocks) noexcept;

}  // namespace tuberia::bench
