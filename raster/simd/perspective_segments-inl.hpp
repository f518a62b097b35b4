// Perspective by segments: weights are divided at every so many pixels of a row and follow a straight
// line in between, as the first game consoles and processors without fast division did it.

#if defined(TUBERIA_RASTER_SIMD_PERSPECTIVE_SEGMENTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_PERSPECTIVE_SEGMENTS_INL
#undef TUBERIA_RASTER_SIMD_PERSPECTIVE_SEGMENTS_INL
#else
#define TUBERIA_RASTER_SIMD_PERSPECTIVE_SEGMENTS_INL
#endif

#include <algorithm>

#include "raster/simd/interpolation-inl.hpp"
#include "raster/simd/quad-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Both ends of a segment are divided in one register, and remembered for the groups of pixels that
/// follow in it. Where 1/w at an end is below half of the triangle's least, the end lies outside the
/// triangle, at the horizon or beyond it: there each pixel divides for itself.
template <class F>
class PerspectiveSegments {
 public:
  /// Corrected weights of the group whose first pixel is (x, y) of the target, in a triangle that is
  /// corrected by segments; linear: its weights on the screen.
  HWY_NOINLINE void correct(const ScreenTriangle& t, int x, int y, const F* linear, F* corrected) {
    const int length = t.perspective, first = x & ~(length - 1);
    Rows& rows = rows_[y / kGroupHeight % kRemembered];
    if (rows.triangle != &t || rows.x != first || rows.y != y) begin(t, first, y, rows);
    const F along = to_float<F>(lane_x() + Int(x - first));
    for (int i = 0; i < 2; ++i) corrected[i] = mul_add(along, load<F>(rows.slope[i]), load<F>(rows.start[i]));
    if (rows.beyond == 0) return;
    F divided[2];
    correct_perspective(t, linear, divided);
    for (int i = 0; i < 2; ++i) corrected[i] = select(mask_of(rows.beyond), divided[i], corrected[i]);
  }

 private:
  /// A segment of each of the rows of a group, spread over its lanes.
  struct Rows {
    const ScreenTriangle* triangle = nullptr;
    int x, y;
    std::uint32_t beyond;  // the rows that cannot be corrected by segments
    alignas(64) float start[2][kLanes], slope[2][kLanes];
  };

  HWY_INLINE void begin(const ScreenTriangle& t, int x, int y, Rows& rows) const {
    rows.triangle = &t, rows.x = x, rows.y = y;
    // The segment's beginning in the even lanes, its end in the odd ones.
    const Int right = (lane_x() & Int(1)) * Int(t.perspective);
    F weight[2];
    if (t.is_near) near_weights(t, x, y, right, weight);
    else far_weights(t, x, y, right, weight);
    const F first = weight[0] * t.inverse_w[1], second = weight[1] * t.inverse_w[2];
    const F sum = mul_add((1.0f - weight[0]) - weight[1], F(t.inverse_w[0]), first + second);
    const float least = std::min(std::min(t.inverse_w[0], t.inverse_w[1]), t.inverse_w[2]);
    const F beyond = select(sum >= 0.5f * least, F(0.0f), F(1.0f));
    rows.beyond = bits_of(even(beyond) + odd(beyond) > 0.0f);
    const F share = reciprocal(sum);
    const F ends[2] = {first * share, second * share};
    for (int i = 0; i < 2; ++i) {
      store(even(ends[i]), rows.start[i]);
      store((odd(ends[i]) - even(ends[i])) * (1.0f / static_cast<float>(t.perspective)), rows.slope[i]);
    }
  }

  static HWY_INLINE F even(F a) { return F(hn::DupEven(a.v)); }
  static HWY_INLINE F odd(F a) { return F(hn::DupOdd(a.v)); }

  /// As the walk finds them: edge functions of near triangles fit 32 bits also next to their tiles.
  static HWY_INLINE void near_weights(const ScreenTriangle& t, int x, int y, Int right, F* weight) {
    for (int i = 0; i < 2; ++i) {
      const std::int32_t per_x = t.per_x[i + 1], per_y = t.per_y[i + 1];
      const std::uint32_t at = static_cast<std::uint32_t>(t.constant_low[i + 1]) + static_cast<std::uint32_t>(per_x) * static_cast<std::uint32_t>(x) +
                               static_cast<std::uint32_t>(per_y) * static_cast<std::uint32_t>(y);
      const Int edge = Int(static_cast<std::int32_t>(at)) + right * Int(per_x) + lane_y() * Int(per_y);
      weight[i] = mul_add(to_float<F>(edge), F(t.weight_scale), F(t.weight_offset[i]));
    }
  }

  /// Both ends from the planes of the square that holds the segment.
  static HWY_INLINE void far_weights(const ScreenTriangle& t, int x, int y, Int right, F* weight) {
    WeightPlanes planes;
    planes.begin(t, {.left = x, .top = y});
    planes.weights(to_float<F>(right + Int(planes.tile_x)), planes.rows<F>(0), weight);
  }

  static constexpr int kRemembered = kBlockSize / kGroupHeight;
  Rows rows_[kRemembered];
};

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
