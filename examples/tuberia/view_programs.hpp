#pragma once
// Fragment programs whose colours are numbers to be read, not looked at: for float targets.

#include <glm/vec2.hpp>

#include "pipeline/fragment_program.hpp"

namespace tuberia::cli {

struct LevelUniforms {
  glm::vec2 texture_size{1};  // texels of level 0
  float last_level = 0;
};

/// The unit normal of world space in red, green and blue.
FragmentProgram show_normals();
/// u, v, and the level of detail that a sampler without bias would take; docs/conventions.md.
FragmentProgram show_texcoords(LevelUniforms uniforms);

}  // namespace tuberia::cli
