// World-space points of fragments in the spaces that techniques compute in.

#if defined(TUBERIA_PIPELINE_PROGRAMS_TRANSFORMED_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_PROGRAMS_TRANSFORMED_INL
#undef TUBERIA_PIPELINE_PROGRAMS_TRANSFORMED_INL
#else
#define TUBERIA_PIPELINE_PROGRAMS_TRANSFORMED_INL
#endif

#include <glm/mat4x4.hpp>

#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// A point in the space of a matrix without a perspective.
template <class F>
HWY_INLINE Vec3<F> transformed(const glm::mat4& m, Vec3<F> p) {
  const auto row = [&](int i) HWY_ATTR { return mul_add(F(m[2][i]), p.z, mul_add(F(m[1][i]), p.y, mul_add(F(m[0][i]), p.x, F(m[3][i])))); };
  return {row(0), row(1), row(2)};
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
