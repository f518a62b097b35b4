#pragma once
// The surface program: reflection, lights and any of the techniques that change one of its parts.

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "math/reflection.hpp"
#include "pipeline/fragment_program.hpp"
#include "pipeline/lighting.hpp"
#include "pipeline/programs/bump_map.hpp"
#include "pipeline/programs/environment_map.hpp"
#include "pipeline/programs/pattern.hpp"
#include "pipeline/programs/shadow_map.hpp"
#include "pipeline/programs/texture_access.hpp"
#include "raster/sampler.hpp"
#include "raster/texture.hpp"

namespace tuberia {

/// Where the colour that multiplies kd comes from.
struct SurfaceColour {
  Pattern pattern{};
  std::shared_ptr<const Texture> texture{};   // instead of the pattern
  Sampler sampler{};
  TextureAccess access{};                     // of the texture, or of a pattern of texture coordinates
};

/// A light with what may stand in its way.
struct SurfaceLight {
  Light light{};
  std::optional<ShadowMap> shadow{};
  std::optional<ProjectedTexture> projected{};
};

/// What becomes of colours above 1.                                               [B 2.8, 2.9]
enum class Overflow : std::uint8_t { kept, hue_preserving };  // kept: the target clamps it, or holds it if it is of floats

struct SurfaceUniforms {
  ReflectionConstants reflection{};
  SurfaceColour colour{};
  BumpMap bump{};
  EnvironmentMap environment{};
  glm::vec3 mirror{0};               // kps: times what the environment shows in the mirror direction, added
  glm::vec3 ambient_light{0.1f};     // Ia
  std::vector<SurfaceLight> lights{};
  glm::vec3 eye{0, 0, 1};            // world space
  bool two_sided = false;
  float alpha = 1;
  NormalInterpolation normals = NormalInterpolation::renormalized;
  Overflow overflow = Overflow::kept;
};

/// I = own * ka Ia + sum over the lights of V Ip falloff (own * kd (N.L) + ks * share) + kps * environment,
/// where `own` is the pattern's or texture's colour and the shares are those of math/reflection.hpp.
/// Reads positions and normals, texture coordinates where a colour or relief is a function of them, and
/// tangents where there is relief (which always goes by the vertices' coordinates). A normal of length 0 is lit by ambient light alone. Refused: numbers that are not
/// finite, a negative exponent, a roughness outside 1e-3 to 1e3, a refractive index outside 1e-3 to 1e3, a
/// missing texture.
FragmentProgram surface(SurfaceUniforms uniforms);

}  // namespace tuberia
