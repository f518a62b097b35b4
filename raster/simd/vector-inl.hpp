// Small vectors of SIMD numbers with GLSL's names, so that a fragment program reads like a shading
// language and shades a whole register of fragments at a time.

#if defined(TUBERIA_RASTER_SIMD_VECTOR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_VECTOR_INL
#undef TUBERIA_RASTER_SIMD_VECTOR_INL
#else
#define TUBERIA_RASTER_SIMD_VECTOR_INL
#endif

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "raster/simd/number-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

template <class F>
struct Vec2 {
  F x, y;
};

template <class F>
struct Vec3 {
  F x, y, z;
  Vec3() = default;
  HWY_INLINE Vec3(F x_, F y_, F z_) : x(x_), y(y_), z(z_) {}
  HWY_INLINE explicit Vec3(F all) : x(all), y(all), z(all) {}
  /// A uniform: the same for all lanes.
  HWY_INLINE Vec3(const glm::vec3& u) : x(u.x), y(u.y), z(u.z) {}
};

template <class F>
struct Vec4 {
  F x, y, z, w;
  Vec4() = default;
  HWY_INLINE Vec4(F x_, F y_, F z_, F w_) : x(x_), y(y_), z(z_), w(w_) {}
  HWY_INLINE Vec4(const Vec3<F>& v, F w_) : x(v.x), y(v.y), z(v.z), w(w_) {}
  HWY_INLINE Vec4(const glm::vec4& u) : x(u.x), y(u.y), z(u.z), w(u.w) {}
  HWY_INLINE Vec3<F> rgb() const { return {x, y, z}; }
  HWY_INLINE F a() const { return w; }
};

#define TUBERIA_VECTOR_OPERATOR(OP)                                                                      \
  template <class F>                                                                                     \
  HWY_INLINE Vec2<F> operator OP(Vec2<F> a, Vec2<F> b) { return {a.x OP b.x, a.y OP b.y}; }              \
  template <class F>                                                                                     \
  HWY_INLINE Vec3<F> operator OP(Vec3<F> a, Vec3<F> b) { return {a.x OP b.x, a.y OP b.y, a.z OP b.z}; }  \
  template <class F>                                                                                     \
  HWY_INLINE Vec4<F> operator OP(Vec4<F> a, Vec4<F> b) {                                                 \
    return {a.x OP b.x, a.y OP b.y, a.z OP b.z, a.w OP b.w};                                             \
  }
TUBERIA_VECTOR_OPERATOR(+)
TUBERIA_VECTOR_OPERATOR(-)
TUBERIA_VECTOR_OPERATOR(*)
#undef TUBERIA_VECTOR_OPERATOR

template <class F>
HWY_INLINE Vec2<F> operator*(Vec2<F> a, F s) { return {a.x * s, a.y * s}; }
template <class F>
HWY_INLINE Vec3<F> operator*(Vec3<F> a, F s) { return {a.x * s, a.y * s, a.z * s}; }
template <class F>
HWY_INLINE Vec4<F> operator*(Vec4<F> a, F s) { return {a.x * s, a.y * s, a.z * s, a.w * s}; }
template <class F>
HWY_INLINE Vec3<F> operator-(Vec3<F> a) { return {-a.x, -a.y, -a.z}; }

template <class F>
HWY_INLINE F dot(Vec2<F> a, Vec2<F> b) { return mul_add(a.y, b.y, a.x * b.x); }
template <class F>
HWY_INLINE F dot(Vec3<F> a, Vec3<F> b) { return mul_add(a.z, b.z, mul_add(a.y, b.y, a.x * b.x)); }
template <class F>
HWY_INLINE Vec3<F> cross(Vec3<F> a, Vec3<F> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class F>
HWY_INLINE F length(Vec3<F> a) { return sqrt(dot(a, a)); }

/// Unit length. The zero vector, and any vector whose squared length leaves the floats' normal
/// range, is first scaled by its largest component; the zero vector stays zero.       [rules S1]
template <class F>
HWY_INLINE Vec3<F> normalize(Vec3<F> a) {
  const F squared = dot(a, a);
  const Mask ordinary = (squared > 1e-30f) & (squared < 1e30f);
  const Vec3<F> usual = a * inverse_sqrt(select(ordinary, squared, F(1.0f)));
  if (all(ordinary)) return usual;

  const F largest = max(max(abs(a.x), abs(a.y)), abs(a.z));
  const Mask scalable = largest > 0.0f;
  // In two steps, since the reciprocal of a denormal number overflows.
  const F shift = select(largest < 1e-20f, F(1e30f), F(1.0f));
  const F divisor = select(scalable, largest * shift, F(1.0f));
  const Vec3<F> scaled{a.x * shift / divisor, a.y * shift / divisor, a.z * shift / divisor};
  const F scaled_squared = select(scalable, dot(scaled, scaled), F(1.0f));
  // A lane's result must not depend on its neighbours', so ordinary lanes keep the usual way.
  const Vec3<F> rescued = scaled * inverse_sqrt(scaled_squared);
  return {select(ordinary, usual.x, rescued.x), select(ordinary, usual.y, rescued.y),
          select(ordinary, usual.z, rescued.z)};
}

/// The mirror image of `incident` (which points towards the surface) in a surface with unit normal.
template <class F>
HWY_INLINE Vec3<F> reflect(Vec3<F> incident, Vec3<F> normal) {
  return incident - normal * (2.0f * dot(incident, normal));
}

template <class F>
HWY_INLINE F mix(F a, F b, F t) { return mul_add(b - a, t, a); }
template <class F>
HWY_INLINE Vec3<F> mix(Vec3<F> a, Vec3<F> b, F t) { return {mix(a.x, b.x, t), mix(a.y, b.y, t), mix(a.z, b.z, t)}; }
template <class F>
HWY_INLINE Vec4<F> mix(Vec4<F> a, Vec4<F> b, F t) {
  return {mix(a.x, b.x, t), mix(a.y, b.y, t), mix(a.z, b.z, t), mix(a.w, b.w, t)};
}
/// Into [0, 1]; not-a-number gives 0.
template <class F>
HWY_INLINE F saturate(F a) { return min(positive_part(a), F(1.0f)); }
template <class F>
HWY_INLINE F clamp(F a, F low, F high) { return min(max(a, low), high); }
template <class F>
HWY_INLINE F smoothstep(float edge0, float edge1, F a) {
  const F t = saturate((a - edge0) / F(edge1 - edge0));
  return t * t * (3.0f - 2.0f * t);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
