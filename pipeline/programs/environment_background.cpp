#include "pipeline/programs/environment_map.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "pipeline/programs/environment_background.cpp"
#include "pipeline/program.hpp"

#include "pipeline/programs/environment-inl.hpp"

TUBERIA_PROGRAM_BEGIN
struct EnvironmentBackgroundProgram : ProgramBase {
  using Uniforms = EnvironmentMap;
  static constexpr Attributes interpolated = Attributes::custom;
  static Refusal refusal(const Uniforms& map) { return refusal_of(map); }

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Uniforms& map) {
    using F = typename Fragment::Number;
    const Vec4<F> direction = in.custom();
    return Vec4<F>(environment_radiance(in, map, Vec3<F>(direction.x, direction.y, direction.z)), F(1.0f));
  }
};
TUBERIA_PROGRAM_END(environment_background, EnvironmentBackgroundProgram)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(environment_background, EnvironmentBackgroundProgram)
tuberia::FragmentProgram tuberia::environment_background(EnvironmentMap map) { return {environment_background_interface(), std::move(map)}; }
#endif
