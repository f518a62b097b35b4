#pragma once
// Lit surfaces, as a recipe wants them shaded.

#include <memory>

#include "bench/trade/recipe.hpp"
#include "raster/texture.hpp"

namespace tuberia::bench::trade {

/// The program for a surface of this material; the state is made to suit it. Without a texture (null) the surface has
/// the material's own colour; with one there is neither flat shading nor that of interpolated cosines.
FragmentProgram lit_program(const Recipe& recipe, Lighting material, const std::shared_ptr<const Texture>& texture,
                            PipelineState& state);

}  // namespace tuberia::bench::trade
