#pragma once
// A mesh made by a test.

#include <vector>

#include "pipeline/draw_call.hpp"

namespace tuberia::test {

/// A mesh that owns its arrays.
struct Mesh {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> texcoords;
  std::vector<glm::vec4> colours, custom;
  std::vector<std::uint32_t> indices;

  MeshView view() const {
    return {.positions = positions, .normals = normals, .texcoords = texcoords, .colours = colours, .custom = custom,
            .indices = indices};
  }
};

}  // namespace tuberia::test
