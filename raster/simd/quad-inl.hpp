// Quads of 2x2 pixels, four lanes each: upper left, upper right, lower left, lower right. What changes from
// one of them to the next stands for the derivative.

#if defined(TUBERIA_RASTER_SIMD_QUAD_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_QUAD_INL
#undef TUBERIA_RASTER_SIMD_QUAD_INL
#else
#define TUBERIA_RASTER_SIMD_QUAD_INL
#endif

#include "raster/simd/number-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Horizontal and vertical difference inside each quad (right minus left, lower minus upper), the
/// same for the two pixels of a row or column.
template <Precision P>
HWY_INLINE Float<P> difference_x(Float<P> a) {
  return Float<P>(hn::Sub(hn::DupOdd(a.v), hn::DupEven(a.v)));
}
template <Precision P>
HWY_INLINE Float<P> difference_y(Float<P> a) {
  const auto upper = hn::Shuffle1032(a.v);  // the two rows of each quad change places
  const auto delta = hn::Sub(upper, a.v);   // lower - upper in the upper row, its negative below
  const auto sign_flipped = hn::Neg(delta);
  const auto lane_in_quad = hn::And(hn::Iota(IntTag{}, 0), hn::Set(IntTag{}, 2));
  return Float<P>(hn::IfThenElse(hn::RebindMask(FloatTag{}, hn::Eq(lane_in_quad, hn::Zero(IntTag{}))),
                                 delta, sign_flipped));
}

/// The same in the lane of the upper left pixel alone; the other lanes mean nothing.
template <Precision P>
HWY_INLINE Float<P> first_difference_x(Float<P> a) { return Float<P>(hn::Sub(hn::Shuffle2301(a.v), a.v)); }
template <Precision P>
HWY_INLINE Float<P> first_difference_y(Float<P> a) { return Float<P>(hn::Sub(hn::Shuffle1032(a.v), a.v)); }

/// The value of each quad's upper left pixel, in all four of its pixels.
template <Precision P>
HWY_INLINE Float<P> first_of_quad(Float<P> a) { return Float<P>(hn::Broadcast<0>(a.v)); }

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
