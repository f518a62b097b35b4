#pragma once
// The surface program: reflection, lights and any of the techniques that change one of its parts.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "pipeline/fragment_program.hpp"
#include "pipeline/programs/bump_map.hpp"
#include "pipeline/programs/environment_map.hpp"
#include "pipeline/programs/pattern.hpp"
#include "pipeline/programs/shadow_map.hpp"
#include "pipeline/state.hpp"
#include "raster/sampler.hpp"
#include "raster/texture.hpp"

namespace tuberia {

/// How a surface reflects the light of a source. Formulas: math/reflection.hpp.
enum class Reflection : std::uint8_t { lambert, phong, blinn_phong, weighted_phong, cook_torrance };

/// The constants of a reflection model, linear RGB.
struct ReflectionConstants {
  Reflection model = Reflection::phong;
  glm::vec3 ambient{0.8f};           // ka, times the scene's ambient light; notes: often equal to kd
  glm::vec3 diffuse{0.8f};           // kd, times the surface's pattern or texture
  glm::vec3 specular{0};             // ks
  float exponent = 32;               // n of phong, blinn_phong and weighted_phong, >= 0
  float roughness = 0.3f;            // m of cook_torrance: root mean square slope of the facets, > 0
  glm::vec3 refractive_index{1.5f};  // of cook_torrance and of weighted_phong's W(theta), > 0, for each channel
  bool divided_by_pi = true;         // cook_torrance as the notes print it: D G F / (pi (N.V)(N.L)), D without 1/pi; false: the later 4 and D with 1/pi [FIX 12]
  bool operator==(const ReflectionConstants&) const = default;
};

/// Where the colour that multiplies kd comes from.
struct SurfaceColour {
  Pattern pattern;
  std::shared_ptr<const Texture> texture;   // instead of the pattern
  Sampler sampler;
};

/// A light with what may stand in its way.
struct SurfaceLight {
  Light light;
  std::optional<ShadowMap> shadow;
  std::optional<ProjectedTexture> projected;
};

/// What becomes of colours above 1.                                               [B 2.8, 2.9]
enum class Overflow : std::uint8_t { kept, hue_preserving };  // kept: the target clamps it, or holds it if it is of floats

struct SurfaceUniforms {
  ReflectionConstants reflection;
  SurfaceColour colour;
  BumpMap bump;
  EnvironmentMap environment;
  glm::vec3 mirror{0};               // kps: times what the environment shows in the mirror direction, added
  glm::vec3 ambient_light{0.1f};     // Ia
  std::vector<SurfaceLight> lights;
  glm::vec3 eye{0, 0, 1};            // world space
  bool two_sided = false;
  float alpha = 1;
  NormalInterpolation normals = NormalInterpolation::renormalized;
  Overflow overflow = Overflow::kept;
};

/// Reads positions and normals, texture coordinates where a colour or relief is a function of them, and
/// tangents where there is relief.
FragmentProgram surface(SurfaceUniforms uniforms);

}  // namespace tuberia
