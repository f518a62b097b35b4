#pragma once
// The oracle's draws as the pipeline's.

#include <vector>

#include "pipeline/pipeline.hpp"
#include "tests/differential/scene.hpp"

namespace tuberia::differential {

/// The arrays that a translated draw refers to.
struct MeshArrays {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> clip_positions, colours, back_colours;
  std::vector<ScreenVertex> screen_positions;
  std::vector<glm::vec2> texcoords;
  std::array<std::vector<glm::vec4>, oracle::kTextureUnits> unit_texcoords;
  std::vector<float> fog_coordinates;
  std::vector<std::uint8_t> edge_flags;
  std::vector<std::uint32_t> indices;
};

MeshArrays arrays_of(const oracle::Draw&);
DrawCall translated(const oracle::Draw&, const MeshArrays&);
ClearCommand translated(const oracle::Clear&);

}  // namespace tuberia::differential
