#include "tests/shadows/light_terms.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "tests/shadows/light_terms.cpp"
#include "pipeline/program.hpp"

#include "pipeline/programs/lighting-inl.hpp"
#include "pipeline/programs/shadow-inl.hpp"

TUBERIA_PROGRAM_BEGIN
struct LightTerms : ProgramBase {
  using Uniforms = test::LightTermsUniforms;
  static constexpr Attributes interpolated = Attributes::position | Attributes::normal;
  static const char* refusal(const Uniforms& uniforms) {
    const char* shadow = uniforms.shadow ? refusal_of(*uniforms.shadow) : nullptr;
    if (shadow || !uniforms.projected) return shadow;
    return refusal_of(*uniforms.projected);
  }

  template <class Fragment>
  static auto shade(Fragment& in, const Uniforms& uniforms) {
    using F = typename Fragment::Number;
    const Vec3<F> point = in.position(), n = normalize(in.normal()), l = towards_light(uniforms.light, point);
    const F cosine = dot(n, l);
    Vec3<F> term(F(1.0f));
    if (uniforms.shadow) term = term * light_visibility(*uniforms.shadow, point, n, l, cosine);
    if (uniforms.projected) term = term * projected_light(in, *uniforms.projected, point);
    return Vec4<F>(term, cosine);
  }
};
TUBERIA_PROGRAM_END(light_terms, LightTerms)

#if HWY_ONCE
TUBERIA_DEFINE_PROGRAM(light_terms, LightTerms)
tuberia::FragmentProgram tuberia::test::light_terms(LightTermsUniforms uniforms) { return {light_terms_interface(), std::move(uniforms)}; }
#endif
