#include "pipeline/programs/programs.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "pipeline/programs/flat.cpp"
#include "pipeline/program.hpp"

TUBERIA_PROGRAM_BEGIN
struct Flat : ProgramBase {
  using Uniforms = NoUniforms;
  static constexpr Attributes flat = Attributes::colour;

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Uniforms&) {
    return in.colour();
  }
};
TUBERIA_PROGRAM_END(flat, Flat)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(flat, Flat)
tuberia::FragmentProgram tuberia::flat() { return {flat_interface(), NoUniforms{}}; }
#endif
