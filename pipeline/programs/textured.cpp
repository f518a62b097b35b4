#include "pipeline/programs/programs.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "pipeline/programs/textured.cpp"
#include "pipeline/program.hpp"

TUBERIA_PROGRAM_BEGIN
template <bool kCutOut>
struct TexturedProgram : ProgramBase {
  using Uniforms = TexturedUniforms;
  static constexpr Attributes interpolated = Attributes::texcoord;
  static constexpr bool may_discard = kCutOut;
  static Refusal refusal(const Uniforms& uniforms) { return uniforms.texture ? Refusal() : Error{"it has no texture"}; }

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Uniforms& uniforms) {
    using F = typename Fragment::Number;
    const Vec4<F> colour = in.sample(*uniforms.texture, uniforms.sampler, in.texcoord()) * Vec4<F>(uniforms.tint);
    if constexpr (kCutOut) in.discard(colour.a() < uniforms.alpha_cutoff);
    return colour;
  }
};
using Textured = TexturedProgram<false>;
using TexturedCutOut = TexturedProgram<true>;
inline const ProgramKernels& textured_cut_out_kernels(Precision precision) { return kernels_of<TexturedCutOut>(precision); }
TUBERIA_PROGRAM_END(textured, Textured)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(textured, Textured)
TUBERIA_DEFINE_PROGRAM(textured_cut_out, TexturedCutOut)
tuberia::FragmentProgram tuberia::textured(TexturedUniforms uniforms, bool cut_out) {
  return {cut_out ? textured_cut_out_interface() : textured_interface(), std::move(uniforms)};
}
#endif
