// Everything a file needs that defines a fragment program; see examples/ for one outside the
// library. Before including this, define TUBERIA_KERNEL_FILE as that file's path from an include
// directory; then write
//
//     TUBERIA_PROGRAM_BEGIN
//     struct Stripes : ProgramBase {
//       using Uniforms = StripesUniforms;                           // a type of your own
//       static constexpr auto interpolated = Attributes::texcoord;  // what it reads
//       template <class Fragment>
//       static auto shade(Fragment& in, const Uniforms& uniforms) { ... return Vec4<...>; }
//     };
//     TUBERIA_PROGRAM_END(stripes, Stripes)
//
//     #if HWY_ONCE
//     TUBERIA_DEFINE_PROGRAM(stripes, Stripes)  // const ProgramInterface& stripes_interface()
//     #endif
//
// The file is compiled once per instruction set; what must exist only once, such as the uniforms,
// lives in a header or in `#if HWY_ONCE`. (No include guard, for the same reason.)

#include "pipeline/fragment_program.hpp"
#include "raster/simd/every_instruction_set.hpp"

#include "pipeline/fragment_chain-inl.hpp"

#ifndef TUBERIA_PIPELINE_PROGRAM
#define TUBERIA_PIPELINE_PROGRAM

#define TUBERIA_PROGRAM_BEGIN \
  HWY_BEFORE_NAMESPACE();     \
  namespace tuberia {         \
  namespace HWY_NAMESPACE {

#define TUBERIA_PROGRAM_END(NAME, PROGRAM)                                                        \
  inline const ProgramKernels& NAME##_kernels(Precision precision) { return kernels_of<PROGRAM>(precision); } \
  }                                                                                               \
  }                                                                                               \
  HWY_AFTER_NAMESPACE();

#define TUBERIA_DEFINE_PROGRAM(NAME, PROGRAM)                                              \
  namespace tuberia {                                                                      \
  const ProgramInterface& NAME##_interface() {                                             \
    static constexpr ProgramInterface kInterface{                                          \
        .name = #NAME,                                                                     \
        .interpolated = HWY_NAMESPACE::PROGRAM::interpolated,                              \
        .flat = HWY_NAMESPACE::PROGRAM::flat,                                              \
        .kernels = [](InstructionSet set, Precision precision) -> const ProgramKernels& {  \
          TUBERIA_RETURN_FOR(set, NAME##_kernels(precision))                               \
        },                                                                                 \
        .may_discard = HWY_NAMESPACE::PROGRAM::may_discard,                                \
        .has_ingredients = HWY_NAMESPACE::PROGRAM::has_ingredients,                        \
        .refusal = [](const void* uniforms) -> Refusal {                                   \
          using Program = HWY_NAMESPACE::PROGRAM;                                          \
          return as_refusal(Program::refusal(*static_cast<const Program::Uniforms*>(uniforms))); \
        }};                                                                                \
    return kInterface;                                                                     \
  }                                                                                        \
  }

#endif
