// The local model of illumination, shared by the vertices (Gouraud) and the fragment programs.

#if defined(TUBERIA_PIPELINE_PROGRAMS_LIGHTING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_PROGRAMS_LIGHTING_INL
#undef TUBERIA_PIPELINE_PROGRAMS_LIGHTING_INL
#else
#define TUBERIA_PIPELINE_PROGRAMS_LIGHTING_INL
#endif

#include <algorithm>

#include "pipeline/lighting.hpp"
#include "pipeline/refusal.hpp"
#include "raster/simd/elementary-inl.hpp"
#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// The normal that a fragment is lit with, from the interpolated one.       [B 3.3] [FIX 7]
template <class F>
HWY_INLINE Vec3<F> fragment_normal(NormalInterpolation normals, Vec3<F> interpolated) {
  switch (normals) {
    case NormalInterpolation::renormalized: break;
    case NormalInterpolation::one_step: return interpolated * ((3.0f - dot(interpolated, interpolated)) * 0.5f);
    case NormalInterpolation::not_renormalized: return interpolated;
  }
  return normalize(interpolated);
}

/// Cosine of the angle between the mirror direction and the eye (Phong), or between the normal and
/// the halfway vector (Blinn).                                                [B 2-7] [C]
template <class F>
HWY_INLINE F highlight_cosine(bool halfway, Vec3<F> n, Vec3<F> l, Vec3<F> v) {
  return halfway ? dot(n, normalize(l + v)) : dot(-reflect(l, n), v);
}

/// n, or where `side` is turned away from the eye, -n.
template <class F>
HWY_INLINE Vec3<F> turned_to(Vec3<F> side, Vec3<F> v, Vec3<F> n) {
  const Mask away = dot(side, v) < 0.0f;
  return {select(away, -n.x, n.x), select(away, -n.y, n.y), select(away, -n.z, n.z)};
}

/// n, or where it is turned away from the eye and the lighting two-sided, -n.
template <class F>
HWY_INLINE Vec3<F> facing_normal(const Lighting& lighting, Vec3<F> n, Vec3<F> v) {
  return lighting.two_sided ? turned_to(n, v, n) : n;
}

/// Unit vector towards a light.
template <class F>
HWY_INLINE Vec3<F> towards_light(const Light& light, Vec3<F> point) {
  const Vec3<F> towards(light.towards);
  return light.kind == Light::Kind::directional ? towards : normalize(towards - point);
}

/// Whether a light's intensity is not the same everywhere.
HWY_INLINE bool is_attenuated(const Light& light) {
  return light.kind == Light::Kind::spot || (light.kind == Light::Kind::point && light.falloff != Falloff::none);
}

/// What of such a light's intensity arrives at a point: falloff times the spot's share. l: unit, towards
/// the light. Distances beyond 1e15 count as 1e15.                            [B 2-5, 2.6]
template <class F>
HWY_INLINE F attenuation(const Light& light, Vec3<F> l, Vec3<F> point) {
  F share(1.0f);
  if (light.falloff != Falloff::none) {
    const Vec3<F> way = Vec3<F>(light.towards) - point;
    const F squared = min(dot(way, way), 1e30f);
    if (light.falloff == Falloff::linear) share = reciprocal(max(sqrt(squared) + light.falloff_distance, kLeastFalloffDistance));
    else share = reciprocal(max(squared, kLeastFalloffDistance * kLeastFalloffDistance)) * 0.0795774715f;  // 1 / (4 pi)
  }
  if (light.kind != Light::Kind::spot) return share;
  // An edge of no width has one of a millionth: smoothstep divides by it.
  const float inner = std::max(light.cos_inner, light.cos_outer + 1e-6f);
  return share * smoothstep(light.cos_outer, inner, -dot(l, Vec3<F>(light.axis)));
}

/// One light's share, from the cosines of light and highlight; the latter is only asked for where
/// something shines. Both terms vanish where the light is below the surface.  [B 2-4, 2-7]
template <class F, class HighlightCosine>
HWY_INLINE Vec3<F> reflected_light(const Lighting& lighting, const Light& light, Vec3<F> diffuse, F light_cosine,
                                   const HighlightCosine& highlight_cosine_of) {
  const F cosine = max(light_cosine, 0.0f);
  Vec3<F> reflected = diffuse * cosine;
  if (lighting.specular != glm::vec3(0)) {
    const F power = pow(max(highlight_cosine_of(), 0.0f), F(lighting.shininess));
    reflected = reflected + Vec3<F>(lighting.specular) * select(cosine > 0.0f, power, F(0.0f));
  }
  return Vec3<F>(light.intensity) * reflected;
}

/// Reflected light at a point. n, v: unit, away from the surface. diffuse: kd there.
template <class F>
HWY_INLINE Vec3<F> illuminate(const Lighting& lighting, Vec3<F> point, Vec3<F> n, Vec3<F> v, Vec3<F> diffuse) {
  n = facing_normal(lighting, n, v);
  Vec3<F> sum(lighting.ambient);
  for (int i = 0; i < lighting.light_count; ++i) {
    const Light& light = lighting.lights[static_cast<std::size_t>(i)];
    const Vec3<F> l = towards_light(light, point);
    Vec3<F> reflected = reflected_light(lighting, light, diffuse, dot(n, l), [&]() HWY_ATTR { return highlight_cosine(lighting.halfway, n, l, v); });
    if (is_attenuated(light)) reflected = reflected * attenuation(light, l, point);
    sum = sum + reflected;
  }
  return sum;
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
