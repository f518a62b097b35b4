// Interpolation over a triangle: depth linearly in screen space, attributes perspective-correctly.

#if defined(TUBERIA_RASTER_SIMD_INTERPOLATION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_INTERPOLATION_INL
#undef TUBERIA_RASTER_SIMD_INTERPOLATION_INL
#else
#define TUBERIA_RASTER_SIMD_INTERPOLATION_INL
#endif

#include "raster/simd/rasterizer-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Depth at screen-space weights, not yet clamped.
template <class F>
HWY_INLINE F interpolated_depth(const ScreenTriangle& t, const F* weight) {
  return mul_add(weight[1], F(t.depth_delta[1]), mul_add(weight[0], F(t.depth_delta[0]), F(t.depth)));
}

/// Screen-space weights to weights on the triangle itself: each is multiplied with its vertex's
/// 1/w and all are divided by their sum. Not by segments.              [C 4.3] [rules P1]
template <class F>
HWY_INLINE void correct_perspective(const ScreenTriangle& t, const F* weight, F* corrected) {
  if (t.perspective == kIsAffine) {
    corrected[0] = weight[0];
    corrected[1] = weight[1];
    return;
  }
  const F q0(t.inverse_w[0]), q1(t.inverse_w[1]), q2(t.inverse_w[2]);
  const F first = weight[0] * q1, second = weight[1] * q2;
  const F rest = (1.0f - weight[0]) - weight[1];
  const F share = reciprocal(mul_add(rest, q0, first + second));
  corrected[0] = first * share;
  corrected[1] = second * share;
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
