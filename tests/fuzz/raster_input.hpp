#pragma once
// A draw made of bytes.

#include <vector>

#include "pipeline/pipeline.hpp"
#include "tests/fuzz/bytes.hpp"

namespace tuberia::fuzz {

/// A target, what it is cleared to, and a draw with all that it refers to.
struct RasterInput {
  RenderTargetDescription target;
  ClearCommand clear;
  PipelineState state;
  FragmentProgram program;
  std::vector<glm::vec4> clip_positions, colours, unit_texcoords;
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> texcoords;
  std::vector<float> fog_coordinates;
  std::vector<std::uint8_t> edge_flags;
  std::vector<std::uint32_t> indices;
  bool is_object_space = false;

  /// Refers to this input.
  DrawCall call() const;
};

RasterInput raster_input(Bytes&);

}  // namespace tuberia::fuzz
