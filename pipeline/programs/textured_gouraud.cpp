#include "pipeline/programs/programs.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "pipeline/programs/textured_gouraud.cpp"
#include "pipeline/program.hpp"

TUBERIA_PROGRAM_BEGIN
struct TexturedGouraud : ProgramBase {
  using Uniforms = TexturedUniforms;
  static constexpr Attributes interpolated = Attributes::texcoord | Attributes::colour;
  static constexpr bool has_ingredients = true;
  static Refusal refusal(const Uniforms& uniforms) { return uniforms.texture ? Refusal() : Error{"it has no texture"}; }

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Uniforms& uniforms) {
    return in.sample(*uniforms.texture, uniforms.sampler, in.texcoord()) * in.colour();
  }
};
TUBERIA_PROGRAM_END(textured_gouraud, TexturedGouraud)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(textured_gouraud, TexturedGouraud)
tuberia::FragmentProgram tuberia::textured_gouraud(TexturedUniforms uniforms) {
  return {textured_gouraud_interface(), std::move(uniforms)};
}
#endif
