#include "pipeline/programs/programs.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "pipeline/programs/dot_product.cpp"
#include "pipeline/program.hpp"

#include "pipeline/programs/lighting-inl.hpp"

TUBERIA_PROGRAM_BEGIN
struct DotProduct : ProgramBase {
  using Uniforms = Lighting;
  static constexpr Attributes interpolated = Attributes::custom;
  static const char* refusal(const Lighting& lighting) {
    return lighting.light_count > 2 ? "it has cosines for two lights at most" : refusal_of(lighting);
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
