#include "pipeline/programs/programs.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "pipeline/programs/textured_lit.cpp"
#include "pipeline/program.hpp"

#include "pipeline/programs/lighting-inl.hpp"

TUBERIA_PROGRAM_BEGIN
template <bool kCutOut>
struct TexturedLitProgram : ProgramBase {
  using Uniforms = TexturedLitUniforms;
  static constexpr Attributes interpolated = Attributes::position | Attributes::normal | Attributes::texcoord;
  static constexpr bool may_discard = kCutOut;
  static constexpr bool has_ingredients = !kCutOut;
  static Refusal refusal(const Uniforms& uniforms) {
    return uniforms.texture ? refusal_of(uniforms.lighting) : Error{"it has no texture"};
  }

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Uniforms& uniforms) {
    using F = typename Fragment::Number;
    const Vec4<F> texel = in.sample(*uniforms.texture, uniforms.sampler, in.texcoord()) * Vec4<F>(uniforms.tint);
    if constexpr (kCutOut) in.discard(texel.a() < uniforms.alpha_cutoff);

    const Lighting& lighting = uniforms.lighting;
    const Vec3<F> point = in.position();
    const Vec3<F> normal = fragment_normal(lighting.normals, in.normal());
    const Vec3<F> eye = normalize(Vec3<F>(lighting.eye) - point);
    // The surface reflects ambient light as it does the lights': by its own colour.
    const Vec3<F> direct = illuminate(lighting, point, normal, eye, texel.rgb() * Vec3<F>(lighting.diffuse));
    const Vec3<F> ambient(lighting.ambient);
    return Vec4<F>(direct - ambient + ambient * texel.rgb(), texel.a() * F(lighting.alpha));
  }
};
using TexturedLit = TexturedLitProgram<false>;
using TexturedLitCutOut = TexturedLitProgram<true>;
inline const ProgramKernels& textured_lit_cut_out_kernels(Precision precision) { return kernels_of<TexturedLitCutOut>(precision); }
TUBERIA_PROGRAM_END(textured_lit, TexturedLit)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(textured_lit, TexturedLit)
TUBERIA_DEFINE_PROGRAM(textured_lit_cut_out, TexturedLitCutOut)
tuberia::FragmentProgram tuberia::textured_lit(TexturedLitUniforms uniforms, bool cut_out) {
  return {cut_out ? textured_lit_cut_out_interface() : textured_lit_interface(), std::move(uniforms)};
}
#endif
