#include "pipeline/programs/fixed_function.hpp"

#include "pipeline/programs/combine.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "pipeline/programs/fixed_function.cpp"
#include "pipeline/program.hpp"

TUBERIA_PROGRAM_BEGIN
/// What a unit's arguments can be, in the order of CombineSource.
template <class F>
struct CombineInputs {
  Vec4<F> source[4];
};

template <class F>
HWY_INLINE Vec3<F> colour_argument(const CombineInputs<F>& in, const CombineArgument& argument) {
  const Vec4<F>& c = in.source[static_cast<int>(argument.source)];
  switch (argument.operand) {
    case CombineOperand::colour: break;
    case CombineOperand::one_minus_colour: return Vec3<F>(F(1.0f)) - c.rgb();
    case CombineOperand::alpha: return Vec3<F>(c.w);
    case CombineOperand::one_minus_alpha: return Vec3<F>(1.0f - c.w);
  }
  return c.rgb();
}

template <class F>
HWY_INLINE F alpha_argument(const CombineInputs<F>& in, const CombineArgument& argument) {
  const F alpha = in.source[static_cast<int>(argument.source)].w;
  const bool as_it_is = argument.operand == CombineOperand::colour || argument.operand == CombineOperand::alpha;
  return as_it_is ? alpha : 1.0f - alpha;
}

template <class F>
HWY_INLINE F combined(CombineFunction function, F a0, F a1, F a2) {
  switch (function) {
    case CombineFunction::modulate: return a0 * a1;
    case CombineFunction::add: return a0 + a1;
    case CombineFunction::add_signed: return (a0 + a1) - 0.5f;
    case CombineFunction::interpolate: return a0 * a2 + a1 * (1.0f - a2);
    case CombineFunction::subtract: return a0 - a1;
    default: return a0;
  }
}

template <class F>
HWY_INLINE F dot3(const Vec3<F>& a, const Vec3<F>& b) {
  return (((a.x - 0.5f) * (b.x - 0.5f) + (a.y - 0.5f) * (b.y - 0.5f)) + (a.z - 0.5f) * (b.z - 0.5f)) * 4.0f;
}

/// Both halves of a unit, scaled and clamped.
template <class F>
HWY_INLINE Vec4<F> combine(const TextureUnit& unit, const CombineInputs<F>& in) {
  const auto clamped = [](F value, int scale) HWY_ATTR { return saturate(value * static_cast<float>(scale)); };
  const Combine& colour = unit.colour;
  const Combine& alpha = unit.alpha;
  const F a = clamped(combined(alpha.function, alpha_argument(in, alpha.argument[0]), alpha_argument(in, alpha.argument[1]),
                               alpha_argument(in, alpha.argument[2])), alpha.scale);
  const Vec3<F> a0 = colour_argument(in, colour.argument[0]), a1 = colour_argument(in, colour.argument[1]), a2 = colour_argument(in, colour.argument[2]);
  if (colour.function == CombineFunction::dot3_rgb || colour.function == CombineFunction::dot3_rgba) {
    const F product = clamped(dot3(a0, a1), colour.scale);
    return {product, product, product, colour.function == CombineFunction::dot3_rgba ? product : a};
  }
  const auto channel = [&](F c0, F c1, F c2) HWY_ATTR { return clamped(combined(colour.function, c0, c1, c2), colour.scale); };
  return {channel(a0.x, a1.x, a2.x), channel(a0.y, a1.y, a2.y), channel(a0.z, a1.z, a2.z), a};
}

template <class F>
HWY_INLINE Vec4<F> unit_texel(const TextureUnit& unit, const Vec4<F>& strq, Mask live) {
  if (unit.texture->kind() == TextureKind::cube) return sample(*unit.texture, unit.sampler, {strq.x, strq.y, strq.z}, strq.w, live);
  const Vec3<F> at{strq.x / strq.w, strq.y / strq.w, strq.z / strq.w};
  if (unit.texture->is_rectangle_of_codes()) return sample(*unit.texture, unit.sampler, Vec2<F>{at.x, at.y}, live);
  return sample(*unit.texture, unit.sampler, at, at.z, live);
}

/// A unit's colour, out of line: it serves every unit and every loop that the program is compiled into.
template <class F>
HWY_NOINLINE Vec4<F> unit_colour(const TextureUnit& unit, const Vec4<F>& strq, const Vec4<F>& primary, const Vec4<F>& previous, const Mask& live) {
  const Rgba32F& k = unit.constant;
  return combine(unit, CombineInputs<F>{{unit_texel(unit, strq, live), {F(k.r), F(k.g), F(k.b), F(k.a)}, primary, previous}});
}

/// With the first kUnits units; a program of its own each, since a program says what it reads.
template <int kUnits>
struct FixedFunctionProgram : ProgramBase {
  using Uniforms = FixedFunctionUniforms;
  static constexpr std::uint32_t kUnitBits = ((1u << kUnits) - 1) * static_cast<std::uint32_t>(Attributes::unit0);
  static constexpr Attributes interpolated = Attributes::colour | static_cast<Attributes>(kUnitBits);
  static Refusal refusal(const Uniforms& uniforms) { return refusal_of(uniforms); }

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Uniforms& uniforms) {
    using F = typename Fragment::Number;
    const Vec4<F> c = in.colour();
    const Vec4<F> primary{saturate(c.x), saturate(c.y), saturate(c.z), saturate(c.w)};
    Vec4<F> previous = primary;
    if constexpr (kUnits > 0) apply<0>(in, uniforms, primary, previous);
    if constexpr (kUnits > 1) apply<1>(in, uniforms, primary, previous);
    if constexpr (kUnits > 2) apply<2>(in, uniforms, primary, previous);
    if constexpr (kUnits > 3) apply<3>(in, uniforms, primary, previous);
    return previous;
  }

 private:
  template <int kUnit, class Fragment, class Colour>
  static HWY_INLINE void apply(const Fragment& in, const Uniforms& uniforms, const Colour& primary, Colour& previous) {
    const TextureUnit& unit = uniforms.units[kUnit];
    if (unit.texture) previous = unit_colour(unit, in.template texture_unit<kUnit>(), primary, previous, in.live());
  }
};
using FixedFunction0 = FixedFunctionProgram<0>;
using FixedFunction1 = FixedFunctionProgram<1>;
using FixedFunction2 = FixedFunctionProgram<2>;
using FixedFunction3 = FixedFunctionProgram<3>;
using FixedFunction4 = FixedFunctionProgram<4>;
inline const ProgramKernels& fixed_function_0_kernels(Precision precision) { return kernels_of<FixedFunction0>(precision); }
inline const ProgramKernels& fixed_function_1_kernels(Precision precision) { return kernels_of<FixedFunction1>(precision); }
inline const ProgramKernels& fixed_function_2_kernels(Precision precision) { return kernels_of<FixedFunction2>(precision); }
inline const ProgramKernels& fixed_function_3_kernels(Precision precision) { return kernels_of<FixedFunction3>(precision); }
TUBERIA_PROGRAM_END(fixed_function_4, FixedFunction4)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(fixed_function_0, FixedFunction0)
TUBERIA_DEFINE_PROGRAM(fixed_function_1, FixedFunction1)
TUBERIA_DEFINE_PROGRAM(fixed_function_2, FixedFunction2)
TUBERIA_DEFINE_PROGRAM(fixed_function_3, FixedFunction3)
TUBERIA_DEFINE_PROGRAM(fixed_function_4, FixedFunction4)
tuberia::FragmentProgram tuberia::fixed_function(FixedFunctionUniforms uniforms) {
  int units = 0;  // up to the last one that is on
  for (int i = 0; i < kTextureUnits; ++i)
    if (uniforms.units[static_cast<std::size_t>(i)].texture) units = i + 1;
  const ProgramInterface* const interfaces[] = {&fixed_function_0_interface(), &fixed_function_1_interface(), &fixed_function_2_interface(),
                                                &fixed_function_3_interface(), &fixed_function_4_interface()};
  return {*interfaces[units], std::move(uniforms)};
}
#endif
