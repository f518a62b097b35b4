#pragma once
// What an application hands to the pipeline.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "pipeline/fragment_program.hpp"
#include "pipeline/state.hpp"
#include "raster/screen_vertex.hpp"

namespace tuberia {

/// A mesh by reference; the arrays must outlive the draw. Object space.
struct MeshView {
  std::span<const glm::vec3> positions{};
  // Instead of positions: already in clip space (no matrix is applied; programs see x, y, z as the
  // world position), or already snapped to the screen (stages 1, 3 and 4 have nothing to do).
  std::span<const glm::vec4> clip_positions{};
  std::span<const ScreenVertex> screen_positions{};
  std::span<const glm::vec3> normals{};     // all that follow: empty, or one a vertex
  std::span<const glm::vec2> texcoords{};
  std::span<const glm::vec4> colours{};     // linear RGBA
  std::span<const glm::vec4> custom{};
  std::span<const glm::vec4> back_colours{};          // see TransformState::two_sided_colours
  std::array<std::span<const glm::vec4>, kTextureUnits> unit_texcoords{};  // (s, t, r, q); empty: texcoords with r 0, q 1
  std::span<const float> fog_coordinates{};           // empty: clip w, the distance along the view in a perspective
  std::span<const std::uint8_t> edge_flags{};         // 0: the edge that begins at this vertex is not drawn in line or point mode
  std::span<const std::uint32_t> indices{}; // empty: the vertices in the order of their arrival
  // dp/du and dp/dv of the texture coordinates [A 1.2]: their lengths count; empty, or one a vertex.
  std::span<const glm::vec3> tangents{}, bitangents{};

  std::size_t vertex_count() const noexcept {
    return !screen_positions.empty() ? screen_positions.size() : !clip_positions.empty() ? clip_positions.size() : positions.size();
  }
  /// How many vertices arrive at primitive assembly.
  std::size_t element_count() const noexcept { return indices.empty() ? vertex_count() : indices.size(); }
};

struct DrawCall {
  MeshView mesh;
  FragmentProgram program;
  PipelineState state;
  bool count_fragments = false;  // fill in the statistics' fragments, at the price of the staged loops
};

/// What became of a draw's primitives. The fragments are counted where the draw asks for it.
struct DrawStatistics {
  std::int64_t triangles_in = 0;      // primitives assembled, points and lines included
  std::int64_t vertices = 0;          // transformed; a shared vertex may count more than once
  std::int64_t triangles_clipped = 0; // crossed the view volume, the guard band or a user plane
  std::int64_t triangles_after_clipping = 0;  // clipping may multiply them
  std::int64_t triangles_drawn = 0;   // survived clipping and culling
  std::int64_t fragments = 0;         // with at least one covered sample
  std::int64_t fragments_shaded = 0;  // handed to the program
  std::int64_t samples_passed = 0;    // all tests: what an occlusion query counts
  DrawStatistics& operator+=(const DrawStatistics& other) noexcept {
    triangles_after_clipping += other.triangles_after_clipping;
    fragments += other.fragments;
    fragments_shaded += other.fragments_shaded;
    samples_passed += other.samples_passed;
    triangles_in += other.triangles_in;
    vertices += other.vertices;
    triangles_clipped += other.triangles_clipped;
    triangles_drawn += other.triangles_drawn;
    return *this;
  }
};

}  // namespace tuberia
