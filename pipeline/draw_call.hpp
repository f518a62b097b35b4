#pragma once
// What an application hands to the pipeline.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "pipeline/fragment_program.hpp"
#include "pipeline/state.hpp"

namespace tuberia {

/// A mesh by reference; the arrays must outlive the draw. Object space.
struct MeshView {
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;     // these four: empty, or one a position
  std::span<const glm::vec2> texcoords;
  std::span<const glm::vec4> colours;     // linear RGBA
  std::span<const glm::vec4> custom;
  std::span<const std::uint32_t> indices; // empty: the vertices in the order of their arrival

  /// How many vertices arrive at primitive assembly.
  std::size_t element_count() const noexcept { return indices.empty() ? positions.size() : indices.size(); }
};

struct DrawCall {
  MeshView mesh;
  FragmentProgram program;
  PipelineState state;
};

/// What became of a draw's triangles.
struct DrawStatistics {
  std::int64_t triangles_in = 0;      // assembled
  std::int64_t vertices = 0;          // transformed; a shared vertex may count more than once
  std::int64_t triangles_clipped = 0; // crossed the view volume or the guard band
  std::int64_t triangles_drawn = 0;   // survived clipping (which may multiply them) and culling
  DrawStatistics& operator+=(const DrawStatistics& other) noexcept {
    triangles_in += other.triangles_in;
    vertices += other.vertices;
    triangles_clipped += other.triangles_clipped;
    triangles_drawn += other.triangles_drawn;
    return *this;
  }
};

}  // namespace tuberia
