#include "pipeline/programs/programs.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "pipeline/programs/gouraud.cpp"
#include "pipeline/program.hpp"

TUBERIA_PROGRAM_BEGIN
struct Gouraud : ProgramBase {
  using Uniforms = NoUniforms;
  static constexpr Attributes interpolated = Attributes::colour;
  static constexpr bool passes_colour_on = true;

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Uniforms&) {
    return in.colour();
  }
};
TUBERIA_PROGRAM_END(gouraud, Gouraud)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(gouraud, Gouraud)
tuberia::FragmentProgram tuberia::gouraud() { return {gouraud_interface(), NoUniforms{}}; }
#endif
