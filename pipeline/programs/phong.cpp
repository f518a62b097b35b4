#include "pipeline/programs/programs.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "pipeline/programs/phong.cpp"
#include "pipeline/program.hpp"

#include "pipeline/programs/lighting-inl.hpp"

TUBERIA_PROGRAM_BEGIN
struct Phong : ProgramBase {
  using Uniforms = Lighting;
  static constexpr Attributes interpolated = Attributes::position | Attributes::normal;
  static constexpr bool has_ingredients = true;
  static Refusal refusal(const Lighting& lighting) { return refusal_of(lighting); }

  template <class Fragment>
  static HWY_INLINE auto shade(Fragment& in, const Lighting& lighting) {
    using F = typename Fragment::Number;
    const Vec3<F> point = in.position();
    const Vec3<F> normal = fragment_normal(lighting.normals, in.normal());
    const Vec3<F> eye = normalize(Vec3<F>(lighting.eye) - point);
    const Vec3<F> colour = illuminate(lighting, point, normal, eye, Vec3<F>(lighting.diffuse));
    return Vec4<F>(colour, F(lighting.alpha));
  }
};
TUBERIA_PROGRAM_END(phong, Phong)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(phong, Phong)
tuberia::FragmentProgram tuberia::phong(const Lighting& lighting) { return {phong_interface(), lighting}; }
#endif
