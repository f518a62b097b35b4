#pragma once
// The fragment programs of the library.

#include <glm/vec4.hpp>
#include <memory>

#include "pipeline/fragment_program.hpp"
#include "pipeline/state.hpp"
#include "raster/sampler.hpp"
#include "raster/texture.hpp"

namespace tuberia {

/// Programs without uniforms.
struct NoUniforms {};

struct TexturedUniforms {
  std::shared_ptr<const Texture> texture;
  Sampler sampler;
  glm::vec4 tint{1};         // multiplies the texture, linear RGBA
  float alpha_cutoff = 0;    // fragments whose alpha is lower are discarded, if cut_out
};

struct TexturedLitUniforms {
  std::shared_ptr<const Texture> texture;
  Sampler sampler;
  glm::vec4 tint{1};
  Lighting lighting;         // its diffuse is multiplied with the texture, its ambient too
  float alpha_cutoff = 0;
};

/// The colour of the triangle's first vertex.
FragmentProgram flat();
/// Vertex colours, interpolated [B 3.2]; with vertex lighting, Gouraud shading.
FragmentProgram gouraud();
/// The local model at every fragment; Lighting::normals says what becomes of the interpolated normal,
/// renormalized unless set otherwise [B 3.3, FIX 7].
FragmentProgram phong(const Lighting& lighting);
/// The local model of interpolated cosines: less than Phong shading interpolates, and no normal is made
/// unit. For one or two lights; TransformState::vertex_cosines, set to the same lighting, makes what it
/// reads, or the mesh has it as its custom attribute.
FragmentProgram dot_product(const Lighting& lighting);
/// The texture times its tint. cut_out: fragments below the alpha cutoff are discarded.
FragmentProgram textured(TexturedUniforms uniforms, bool cut_out = false);
/// The texture times the interpolated vertex colours, lit or not; tint and cutoff are not read.
FragmentProgram textured_gouraud(TexturedUniforms uniforms);
/// The local model with the texture's colour as its diffuse colour.
FragmentProgram textured_lit(TexturedLitUniforms uniforms, bool cut_out = false);

}  // namespace tuberia
