#include "tests/pipeline/sampling_program_kernels.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "tests/pipeline/sampling_program_kernels.cpp"
#include "pipeline/program.hpp"

TUBERIA_PROGRAM_BEGIN
struct SampleCallProgram : ProgramBase {
  using Uniforms = test::SampleCallUniforms;
  static constexpr Attributes interpolated = Attributes::custom;

  template <class Fragment>
  static auto shade(Fragment& in, const Uniforms& uniforms) {
    using F = typename Fragment::Number;
    const Vec4<F> at = in.custom();
    const Texture& texture = *uniforms.texture;
    switch (uniforms.call) {
      case test::SampleCall::one: return in.sample(texture, uniforms.sampler, at.x);
      case test::SampleCall::two: return in.sample(texture, uniforms.sampler, Vec2<F>{at.x, at.y});
      case test::SampleCall::three: return in.sample(texture, uniforms.sampler, Vec3<F>(at.x, at.y, at.z));
      case test::SampleCall::compared: break;
    }
    return in.sample(texture, uniforms.sampler, Vec3<F>(at.x, at.y, at.z), at.w);
  }
};
struct SampleDiscardedProgram : ProgramBase {
  using Uniforms = test::SampleCallUniforms;
  static constexpr Attributes interpolated = Attributes::custom;
  static constexpr bool may_discard = true;

  template <class Fragment>
  static auto shade(Fragment& in, const Uniforms& uniforms) {
    using F = typename Fragment::Number;
    const Vec4<F> at = in.custom();
    in.discard(at.x == at.x);
    return in.sample(*uniforms.texture, uniforms.sampler, Vec2<F>{at.x, at.y});
  }
};
inline const ProgramKernels& sample_discarded_kernels(Precision precision) { return kernels_of<SampleDiscardedProgram>(precision); }
TUBERIA_PROGRAM_END(sample_call, SampleCallProgram)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(sample_call, SampleCallProgram)
TUBERIA_DEFINE_PROGRAM(sample_discarded, SampleDiscardedProgram)
tuberia::FragmentProgram tuberia::test::sample_discarded(SampleCallUniforms uniforms) { return {sample_discarded_interface(), std::move(uniforms)}; }
tuberia::FragmentProgram tuberia::test::sample_call(SampleCallUniforms uniforms) { return {sample_call_interface(), std::move(uniforms)}; }
#endif
