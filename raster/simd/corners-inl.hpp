// The corners of triangles on the snapped screen, in bulk: in 32-bit integers where that is enough,
// in doubles where it is not.

#if defined(TUBERIA_RASTER_SIMD_CORNERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_CORNERS_INL
#undef TUBERIA_RASTER_SIMD_CORNERS_INL
#else
#define TUBERIA_RASTER_SIMD_CORNERS_INL
#endif

#include "math/fixed_point.hpp"
#include "raster/geometry_kernels.hpp"
#include "raster/simd/double-inl.hpp"
#include "raster/simd/records-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// The corners of a register of triangles; 24.8 units. `depth` and `w` are the bits of floats.
struct Corners {
  Int x[3], y[3], depth[3], w[3];
};

HWY_INLINE Corners load_corners(const TriangleArrays& t, int i, const ScreenVertex* vertices) {
  const std::uint32_t* slots[3] = {t.v0 + i, t.v1 + i, t.v2 + i};
  Corners c;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t* const slot = slots[k];
    Int field[4];
    load_records([&](int lane) HWY_ATTR { return &vertices[slot[lane]].x; }, field);
    c.x[k] = field[0], c.y[k] = field[1], c.depth[k] = field[2], c.w[k] = field[3];
  }
  return c;
}

HWY_INLINE Int smallest(const Int (&v)[3]) { return min(min(v[0], v[1]), v[2]); }
HWY_INLINE Int largest(const Int (&v)[3]) { return max(max(v[0], v[1]), v[2]); }

/// The larger of a triangle's width and height.
HWY_INLINE Int span_of(const Corners& c) { return max(largest(c.x) - smallest(c.x), largest(c.y) - smallest(c.y)); }

// Spans below 64 pixels: edge functions at pixels less than two pixels outside the bounds stay below
// 2 * (2^14 + 2 * 2^8)^2 < 2^30, so 32 bits hold them and the area, and sums of three.
inline constexpr std::int32_t kSmallSpanUnits = 64 * kSubpixelUnits;
static_assert(2ll * (kSmallSpanUnits + 2 * kSubpixelUnits) * (kSmallSpanUnits + 2 * kSubpixelUnits) < 1ll << 30);

/// The pixels whose centres lie within the bounds of the corners, or less than a margin beside them;
/// inclusive.
struct PixelBounds {
  Int left, top, right, bottom;
};

HWY_INLINE PixelBounds pixel_bounds(const Corners& c, int margin_pixels) {
  const std::int32_t margin = margin_pixels * kSubpixelUnits;
  const Int up(kSubpixelUnits - 1 - kPixelCentre - margin), down(margin - kPixelCentre);
  return {arithmetic_shift_right<kSubpixelBits>(smallest(c.x) + up), arithmetic_shift_right<kSubpixelBits>(smallest(c.y) + up),
          arithmetic_shift_right<kSubpixelBits>(largest(c.x) + down), arithmetic_shift_right<kSubpixelBits>(largest(c.y) + down)};
}

/// The edge functions of small triangles at the centre of a pixel near their bounds, without the
/// top-left rule. Edge k runs from vertex k+1 to vertex k+2; their sum is twice the area.
struct EdgeValues {
  Int at[3];
  HWY_INLINE Int twice_area() const { return at[0] + at[1] + at[2]; }
};

HWY_INLINE EdgeValues edges_at(const Corners& c, Int pixel_x, Int pixel_y) {
  const Int centre_x = shift_left<kSubpixelBits>(pixel_x) + Int(kPixelCentre), centre_y = shift_left<kSubpixelBits>(pixel_y) + Int(kPixelCentre);
  Int x[3], y[3];
  for (int k = 0; k < 3; ++k) x[k] = c.x[k] - centre_x, y[k] = c.y[k] - centre_y;
  EdgeValues edges;
  for (int k = 0; k < 3; ++k) {
    const int from = (k + 1) % 3, to = (k + 2) % 3;
    edges.at[k] = x[from] * y[to] - x[to] * y[from];
  }
  return edges;
}

/// -1 where edges of small triangles are neither left nor top: they do not own the points on them,
/// so E > 0, which is E - 1 >= 0, decides. 0 elsewhere.
HWY_INLINE Int top_left_rule(Int per_x, Int per_y) {
  // One number with the sign of per_x or, where that is 0, of per_y.
  return arithmetic_shift_right<31>(shift_left<16>(per_x) + per_y - Int(1));
}

// Doubles: 24.8 units are exact in them, and so are their products and the sums of two.

HWY_INLINE Double lower_doubles(Int a) { return Double(hn::PromoteTo(DoubleTag{}, hn::LowerHalf(HalfIntTag{}, a.v))); }
HWY_INLINE Double upper_doubles(Int a) { return Double(hn::PromoteTo(DoubleTag{}, hn::UpperHalf(HalfIntTag{}, a.v))); }

/// Half a register of corners.
struct DoubleCorners {
  Double x[3], y[3];
};

HWY_INLINE DoubleCorners half_of(const Corners& c, bool upper) {
  DoubleCorners half;
  for (int k = 0; k < 3; ++k) {
    half.x[k] = upper ? upper_doubles(c.x[k]) : lower_doubles(c.x[k]);
    half.y[k] = upper ? upper_doubles(c.y[k]) : lower_doubles(c.y[k]);
  }
  return half;
}

/// Twice the signed area, positive for clockwise on the screen; |.| <= 2^49, exact.
HWY_INLINE Double twice_area(const DoubleCorners& c) {
  return (c.x[1] - c.x[0]) * (c.y[2] - c.y[0]) - (c.y[1] - c.y[0]) * (c.x[2] - c.x[0]);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
