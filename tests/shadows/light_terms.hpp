#pragma once
// A program that shows one light's visibility, thrown picture and cosine, apart from any reflection model.

#include <optional>

#include "pipeline/fragment_program.hpp"
#include "pipeline/programs/shadow_map.hpp"
#include "pipeline/state.hpp"

namespace tuberia::test {

struct LightTermsUniforms {
  Light light;
  std::optional<ShadowMap> shadow{};
  std::optional<ProjectedTexture> projected{};
};

/// Colour: visibility times the thrown picture (white without one). Alpha: the light's cosine, negative where
/// the surface is turned away.
FragmentProgram light_terms(LightTermsUniforms uniforms);

}  // namespace tuberia::test
