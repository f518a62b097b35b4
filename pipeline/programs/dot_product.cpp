#include "pipeline/programs/programs.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "pipeline/programs/dot_product.cpp"
#include "pipeline/program.hpp"

#include "pipeline/programs/lighting-inl.hpp"

TUBERIA_PROGRAM_BEGIN
struct DotProduct : ProgramBase {
  using Uniforms = Lighting;
  static constexpr Attributes interpolated = Attributes::custom;
  static Refusal refusal(const Lighting& lighting) {
    if (lighting.light_count > 2) return Error{"it has cosines for two lights at most"};
    if (Refusal refusal = refusal_of(lighting)) return refusal;
    // Whatever a cosine is multiplied with, its power is 1.
    for (int i = 0; i < lighting.light_count && lighting.shininess == 0; ++i)
      if (is_attenuated(lighting.lights[static_cast<std::size_t>(i)]) && lighting.specular != glm::vec3(0))
        return Error{"shininess is 0, and lights[" + std::to_string(i) + "] has a falloff or a spot, which it cannot make such a highlight follow"};
    return {};
  }

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Lighting& lighting) {
    using F = typename Fragment::Number;
    const Vec4<F> cosines = in.custom();
    const F of_light[2] = {cosines.x, cosines.z}, of_highlight[2] = {cosines.y, cosines.w};
    Vec3<F> sum(lighting.ambient);
    for (int i = 0; i < lighting.light_count; ++i)
      sum = sum + reflected_light(lighting, lighting.lights[static_cast<std::size_t>(i)], Vec3<F>(lighting.diffuse), of_light[i],
                                  [&]() HWY_ATTR { return of_highlight[i]; });
    return Vec4<F>(sum, F(lighting.alpha));
  }
};
TUBERIA_PROGRAM_END(dot_product, DotProduct)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(dot_product, DotProduct)
tuberia::FragmentProgram tuberia::dot_product(const Lighting& lighting) { return {dot_product_interface(), lighting}; }
#endif
