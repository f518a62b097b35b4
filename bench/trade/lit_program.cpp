#include "bench/trade/lit_program.hpp"

#include "pipeline/programs/programs.hpp"

namespace tuberia::bench::trade {

FragmentProgram lit_program(const Recipe& recipe, Lighting material, const std::shared_ptr<const Texture>& texture,
                            PipelineState& state) {
  material.normals = recipe.normals;
  if (recipe.shading == Shading::phong) {
    if (texture == nullptr) return phong(material);
    return textured_lit({.texture = texture, .sampler = recipe.sampler, .lighting = material});
  }
  if (recipe.shading == Shading::dot_product && texture == nullptr) {
    state.transform.vertex_cosines = material;
    return dot_product(material);
  }
  state.transform.vertex_lighting = material;
  if (texture != nullptr) return textured_gouraud({.texture = texture, .sampler = recipe.sampler});
  state.rasterization.flat_shading = recipe.shading == Shading::flat;
  return gouraud();
}

}  // namespace tuberia::bench::trade
