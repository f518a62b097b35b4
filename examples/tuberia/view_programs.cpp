#include "examples/tuberia/view_programs.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "examples/tuberia/view_programs.cpp"
#include "pipeline/program.hpp"

#include "raster/simd/elementary-inl.hpp"

#ifndef TUBERIA_SHOW_NORMALS_UNIFORMS
#define TUBERIA_SHOW_NORMALS_UNIFORMS
namespace tuberia::cli {
struct NoUniformsOfNormals {};
}  // namespace tuberia::cli
#endif

TUBERIA_PROGRAM_BEGIN
struct ShowNormals : ProgramBase {
  using Uniforms = cli::NoUniformsOfNormals;
  static constexpr Attributes interpolated = Attributes::normal;

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Uniforms&) {
    using F = typename Fragment::Number;
    return Vec4<F>(normalize(in.normal()), F(1.0f));
  }
};

struct ShowTexcoords : ProgramBase {
  using Uniforms = cli::LevelUniforms;
  static constexpr Attributes interpolated = Attributes::texcoord;

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Uniforms& uniforms) {
    using F = typename Fragment::Number;
    const Vec2<F> uv = in.texcoord();
    const F u = uv.x * uniforms.texture_size.x, v = uv.y * uniforms.texture_size.y;
    const Vec2<F> along_x{difference_x(u), difference_x(v)}, along_y{difference_y(u), difference_y(v)};
    // Half the logarithm of the square; a square of 0 is level 0.
    const F square = max(max(dot(along_x, along_x), dot(along_y, along_y)), F(1e-30f));
    return Vec4<F>(uv.x, uv.y, clamp(log2(square) * 0.5f, F(0.0f), F(uniforms.last_level)), F(1.0f));
  }
};
inline const ProgramKernels& show_texcoords_kernels(Precision precision) { return kernels_of<ShowTexcoords>(precision); }
TUBERIA_PROGRAM_END(show_normals, ShowNormals)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(show_normals, ShowNormals)
TUBERIA_DEFINE_PROGRAM(show_texcoords, ShowTexcoords)

namespace tuberia::cli {
FragmentProgram show_normals() { return {show_normals_interface(), NoUniformsOfNormals{}}; }
FragmentProgram show_texcoords(LevelUniforms uniforms) { return {show_texcoords_interface(), uniforms}; }
}  // namespace tuberia::cli
#endif
