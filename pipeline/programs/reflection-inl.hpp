// The specular part of the reflection models, a register of fragments at a time. Their definition is
// math/reflection.hpp.

#if defined(TUBERIA_PIPELINE_PROGRAMS_REFLECTION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_PROGRAMS_REFLECTION_INL
#undef TUBERIA_PIPELINE_PROGRAMS_REFLECTION_INL
#else
#define TUBERIA_PIPELINE_PROGRAMS_REFLECTION_INL
#endif

#include "math/reflection.hpp"
#include "pipeline/programs/lighting-inl.hpp"
#include "raster/simd/elementary-inl.hpp"
#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// What a clear material reflects; c: in [0, 1].                                       [FIX 11]
template <class F>
HWY_INLINE F fresnel_share(F c, float refractive_index) {
  const F g_squared = mul_add(c, c, F((refractive_index - 1) * (refractive_index + 1)));
  const F g = sqrt(max(g_squared, 0.0f)), sum = g + c, difference = g - c;
  // Between equals nothing is reflected, not even along the surface, where the sum is 0.
  const F across = difference * reciprocal(max(sum, 1e-20f));
  const F within = mul_add(c, sum, F(-1.0f)) * reciprocal(max(mul_add(c, difference, F(1.0f)), 1e-20f));
  const F share = 0.5f * (across * across) * mul_add(within, within, F(1.0f));
  return select(g_squared < 0.0f, F(1.0f), share);  // beyond the critical angle
}

template <class F>
HWY_INLINE Vec3<F> fresnel_shares(F c, const glm::vec3& refractive_index) {
  const F red = fresnel_share(c, refractive_index.x);
  if (refractive_index.y == refractive_index.x && refractive_index.z == refractive_index.x) return Vec3<F>(red);
  return {red, fresnel_share(c, refractive_index.y), fresnel_share(c, refractive_index.z)};
}

/// The square of the angle between unit vectors, of q = |n - h|^2 <= 2: 2 asin(sqrt(q)/2), squared, as a
/// polynomial. Largest relative error 4e-7.
template <class F>
HWY_INLINE F squared_angle(Vec3<F> n, Vec3<F> h) {
  const Vec3<F> difference = n - h;
  const F q = min(dot(difference, difference), 2.0f);
  F series(7.16249342e-5f);
  series = mul_add(series, q, F(-1.63288452e-4f));
  series = mul_add(series, q, F(6.73425209e-4f));
  series = mul_add(series, q, F(1.51119439e-3f));
  series = mul_add(series, q, F(1.12089561e-2f));
  series = mul_add(series, q, F(8.33204836e-2f));
  return q * mul_add(series, q, F(1.00000024f));
}

/// D, without 1/pi. The tangent comes from the cross product: 1 - cos^2 would have lost what tells the
/// facets of a smooth surface apart.
template <class F>
HWY_INLINE F facet_density(const ReflectionConstants& constants, Vec3<F> n, Vec3<F> h, F cos_facet) {
  const float m_squared = constants.roughness * constants.roughness, log2_e_over_m_squared = 1.44269504f / m_squared;
  if (constants.facets == FacetDistribution::gaussian)
    return exp2(squared_angle(n, h) * -log2_e_over_m_squared) * (1 / m_squared);
  const Vec3<F> sine = cross(n, h);
  const F inverse = reciprocal(max(cos_facet * cos_facet, 1e-12f));  // at the limit the power is 0
  return exp2(dot(sine, sine) * inverse * -log2_e_over_m_squared) * (inverse * inverse * (1 / m_squared));
}

template <class F>
HWY_INLINE Vec3<F> cook_torrance_share(const ReflectionConstants& constants, Vec3<F> n, Vec3<F> l, Vec3<F> v, F cos_light) {
  const Vec3<F> h = normalize(l + v);
  const F cos_eye = dot(n, v), cos_facet = max(dot(n, h), 0.0f), cos_ray = clamp(dot(v, h), F(0.0f), F(1.0f));
  const F lesser = max(min(cos_light, cos_eye), 0.0f);
  const F unhidden = min(2.0f * cos_facet * lesser * reciprocal(max(cos_ray, 1e-20f)), F(1.0f));
  const float divisor = constants.divided_by_pi ? 3.14159265f : 4.0f;
  const F share = facet_density(constants, n, h, cos_facet) * unhidden * reciprocal(max(cos_eye, 1e-6f) * divisor);
  const F above = select((cos_eye > 0.0f) & (cos_facet > 0.0f), share, F(0.0f));
  return fresnel_shares(cos_ray, constants.refractive_index) * above;
}

/// A model's specular share of a light with n.l = cos_light > 0; elsewhere the result means nothing.
template <class F>
HWY_INLINE Vec3<F> specular_share(const ReflectionConstants& constants, Vec3<F> n, Vec3<F> l, Vec3<F> v, F cos_light) {
  if (constants.model == Reflection::cook_torrance) return cook_torrance_share(constants, n, l, v, cos_light);
  const F cosine = highlight_cosine(constants.model == Reflection::blinn_phong, n, l, v);
  const F power = pow(max(cosine, 0.0f), F(constants.exponent));
  if (constants.model != Reflection::weighted_phong) return Vec3<F>(power);
  return fresnel_shares(min(max(cos_light, 0.0f), 1.0f), constants.refractive_index) * power;
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
