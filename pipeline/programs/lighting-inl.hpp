// The local model of illumination, shared by the vertices (Gouraud) and the fragment programs.

#if defined(TUBERIA_PIPELINE_PROGRAMS_LIGHTING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_PROGRAMS_LIGHTING_INL
#undef TUBERIA_PIPELINE_PROGRAMS_LIGHTING_INL
#else
#define TUBERIA_PIPELINE_PROGRAMS_LIGHTING_INL
#endif

#include "pipeline/refusal.hpp"
#include "pipeline/state.hpp"
#include "raster/simd/elementary-inl.hpp"
#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// cos^n of the angle between the mirror direction and the eye (Phong), or between the normal and
/// the halfway vector (Blinn).                                                [B 2-7] [C]
template <class F>
HWY_INLINE F highlight(const Lighting& lighting, Vec3<F> n, Vec3<F> l, Vec3<F> v) {
  const F cosine = lighting.halfway ? dot(n, normalize(l + v)) : dot(-reflect(l, n), v);
  return pow(max(cosine, 0.0f), F(lighting.shininess));
}

/// Reflected light at a point. n, v: unit, away from the surface. diffuse: kd there.
/// Both terms of a light vanish where it is below the surface.                [B 2-4, 2-7]
template <class F>
HWY_INLINE Vec3<F> illuminate(const Lighting& lighting, Vec3<F> point, Vec3<F> n, Vec3<F> v, Vec3<F> diffuse) {
  if (lighting.two_sided) {
    const Mask away = dot(n, v) < 0.0f;
    n = {select(away, -n.x, n.x), select(away, -n.y, n.y), select(away, -n.z, n.z)};
  }
  const bool shines = lighting.specular != glm::vec3(0);
  Vec3<F> sum(lighting.ambient);
  for (int i = 0; i < lighting.light_count; ++i) {
    const Light& light = lighting.lights[static_cast<std::size_t>(i)];
    const Vec3<F> towards(light.towards);
    const Vec3<F> l = light.kind == Light::Kind::directional ? towards : normalize(towards - point);
    const F cosine = max(dot(n, l), 0.0f);
    Vec3<F> reflected = diffuse * cosine;
    if (shines) {
      const F strength = select(cosine > 0.0f, highlight(lighting, n, l, v), F(0.0f));
      reflected = reflected + Vec3<F>(lighting.specular) * strength;
    }
    sum = sum + Vec3<F>(light.intensity) * reflected;
  }
  return sum;
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
