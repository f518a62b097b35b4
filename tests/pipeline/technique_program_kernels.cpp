#include "tests/pipeline/technique_program_kernels.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "tests/pipeline/technique_program_kernels.cpp"
#include "pipeline/program.hpp"

#include "pipeline/programs/bump-inl.hpp"
#include "pipeline/programs/pattern-inl.hpp"
#include "pipeline/programs/texture_access-inl.hpp"

TUBERIA_PROGRAM_BEGIN
struct TechniqueProgram : ProgramBase {
  using Uniforms = test::TechniqueUniforms;
  static constexpr Attributes interpolated = Attributes::position | Attributes::normal | Attributes::texcoord | Attributes::unit0 | Attributes::unit1;

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Uniforms& uniforms) {
    using F = typename Fragment::Number;
    const Vec3<F> point = in.position();
    const Vec2<F> uv = accessed_texcoord(uniforms.access, in.texcoord(), point);
    switch (uniforms.shown) {
      case test::Shown::pattern: return Vec4<F>(pattern_colour(uniforms.pattern, uv, point), F(1.0f));
      case test::Shown::bumped_normal: {
        const SurfaceBasis<F> basis{in.template texture_unit<0>().rgb(), in.template texture_unit<1>().rgb(), in.normal()};
        return Vec4<F>(bumped_normal(in, uniforms.bump, uv, basis), F(1.0f));
      }
      case test::Shown::sphere_coordinates: {
        const Vec2<F> at = sphere_coordinates(transformed(uniforms.access.globe_from_world, point));
        return Vec4<F>(at.x, at.y, F(0.0f), F(1.0f));
      }
      case test::Shown::texture: break;
    }
    return accessed_colour(in, *uniforms.texture, uniforms.sampler, uniforms.access, uv, Vec3<F>(uniforms.eye), point);
  }
};
TUBERIA_PROGRAM_END(technique, TechniqueProgram)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(technique, TechniqueProgram)
tuberia::FragmentProgram tuberia::test::technique(TechniqueUniforms uniforms) { return {technique_interface(), std::move(uniforms)}; }
#endif
