#pragma once
// A program that shows what one technique computes, without light: patterns, relief, texture access.

#include <glm/vec3.hpp>
#include <memory>

#include "pipeline/fragment_program.hpp"
#include "pipeline/programs/bump_map.hpp"
#include "pipeline/programs/pattern.hpp"
#include "pipeline/programs/texture_access.hpp"

namespace tuberia::test {

enum class Shown { pattern, bumped_normal, sphere_coordinates, texture };

struct TechniqueUniforms {
  Shown shown = Shown::pattern;
  Pattern pattern{};
  BumpMap bump{};
  TextureAccess access{};
  std::shared_ptr<const Texture> texture{};
  Sampler sampler{};
  glm::vec3 eye{0, 0, 1};
};

/// pattern and texture: the colour. bumped_normal: of the tangents in texture units 0 and 1, as it is.
/// sphere_coordinates: (u, v) of the access' globe as notes 7.2 have them, not turned upside down.
FragmentProgram technique(TechniqueUniforms uniforms);

}  // namespace tuberia::test
