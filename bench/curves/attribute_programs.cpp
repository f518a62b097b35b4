#include "bench/curves/attribute_programs.hpp"

#ifndef ATTRIBUTE_PROGRAM_UNIFORMS  // exists once, although the file is compiled several times
#define ATTRIBUTE_PROGRAM_UNIFORMS
namespace tuberia::bench {
struct NoAttributeUniforms {};
}  // namespace tuberia::bench
#endif

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "bench/curves/attribute_programs.cpp"
#include "pipeline/program.hpp"

TUBERIA_PROGRAM_BEGIN

/// A colour that is the sum of all that is interpolated.
template <Attributes kRead>
struct SumOfAttributes : ProgramBase {
  using Uniforms = bench::NoAttributeUniforms;
  static constexpr Attributes interpolated = kRead;

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Uniforms&) {
    using F = typename Fragment::Number;
    Vec4<F> sum{F(0.1f), F(0.2f), F(0.3f), F(0.25f)};
    if constexpr (contains(kRead, Attributes::colour)) sum = sum + in.colour();
    if constexpr (contains(kRead, Attributes::custom)) sum = sum + in.custom();
    if constexpr (contains(kRead, Attributes::texcoord)) sum = sum + Vec4<F>{in.texcoord().x, in.texcoord().y, F(0.0f), F(0.0f)};
    if constexpr (contains(kRead, Attributes::normal)) sum = sum + Vec4<F>(in.normal(), F(0.0f));
    if constexpr (contains(kRead, Attributes::position)) sum = sum + Vec4<F>(in.position(), F(0.0f));
    return sum;
  }
};

using SumOfNone = SumOfAttributes<Attributes::none>;
using SumOfTexcoord = SumOfAttributes<Attributes::texcoord>;
using SumOfColour = SumOfAttributes<Attributes::colour>;
using SumOfTwo = SumOfAttributes<Attributes::colour | Attributes::custom>;
using SumOfAll = SumOfAttributes<Attributes::position | Attributes::normal | Attributes::texcoord |
                                 Attributes::colour | Attributes::custom>;

TUBERIA_PROGRAM_END(sum_of_all, SumOfAll)
TUBERIA_PROGRAM_BEGIN
// The macro that ends a block makes the kernels of one program; these are made as it makes them.
inline const ProgramKernels& sum_of_none_kernels(Precision precision) { return kernels_of<SumOfNone>(precision); }
inline const ProgramKernels& sum_of_texcoord_kernels(Precision precision) { return kernels_of<SumOfTexcoord>(precision); }
inline const ProgramKernels& sum_of_colour_kernels(Precision precision) { return kernels_of<SumOfColour>(precision); }
TUBERIA_PROGRAM_END(sum_of_two, SumOfTwo)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(sum_of_none, SumOfNone)
TUBERIA_DEFINE_PROGRAM(sum_of_texcoord, SumOfTexcoord)
TUBERIA_DEFINE_PROGRAM(sum_of_colour, SumOfColour)
TUBERIA_DEFINE_PROGRAM(sum_of_two, SumOfTwo)
TUBERIA_DEFINE_PROGRAM(sum_of_all, SumOfAll)

std::vector<tuberia::bench::AttributeProgram> tuberia::bench::attribute_programs() {
  constexpr NoAttributeUniforms kNone{};
  return {{0, {sum_of_none_interface(), kNone}},
          {2, {sum_of_texcoord_interface(), kNone}},
          {4, {sum_of_colour_interface(), kNone}},
          {8, {sum_of_two_interface(), kNone}},
          {16, {sum_of_all_interface(), kNone}}};
}
#endif
