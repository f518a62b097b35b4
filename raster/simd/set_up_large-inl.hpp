// Set-up in bulk of triangles of any size, in doubles.

#if defined(TUBERIA_RASTER_SIMD_SET_UP_LARGE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_SET_UP_LARGE_INL
#undef TUBERIA_RASTER_SIMD_SET_UP_LARGE_INL
#else
#define TUBERIA_RASTER_SIMD_SET_UP_LARGE_INL
#endif

#include "raster/simd/corners-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Half a register of set-up triangles, field by field.
struct SetupLanes {
  alignas(64) std::int32_t per_x[3][kDoubleLanes], per_y[3][kDoubleLanes];
  alignas(64) double constant[3][kDoubleLanes];
  alignas(64) float weight_scale[kDoubleLanes], weight_offset[2][kDoubleLanes];
  alignas(64) float depth[3][kDoubleLanes], inverse_w[3][kDoubleLanes];
  alignas(64) std::int32_t bounds[4][kDoubleLanes], remainder[3][kDoubleLanes];
  std::uint32_t affine, near;
};

/// Edge functions at pixel centres, split into whole multiples of 256 and remainder: see
/// ScreenTriangle. Edge k runs from vertex k+1 to vertex k+2. Only samples want the remainder.
template <bool kHasSamples>
HWY_INLINE void set_up_edges(const DoubleCorners& c, SetupLanes& out) {
  const Double inverse_area = Double(1.0) / twice_area(c);
  store(Double(kSubpixelUnits) * inverse_area, out.weight_scale);
  for (int k = 0; k < 3; ++k) {
    const int from = (k + 1) % 3, to = (k + 2) % 3;
    const Double per_x = c.y[from] - c.y[to], per_y = c.x[to] - c.x[from];
    const Double at_centre = per_x * (Double(kPixelCentre) - c.x[from]) + per_y * (Double(kPixelCentre) - c.y[from]);
    // Edges that are neither left nor top do not own the points on them: E > 0 is E - 1 >= 0.
    const DoubleMask top_left = (per_x > Double(0.0)) | ((per_x == Double(0.0)) & (per_y > Double(0.0)));
    const Double rule = select(top_left, Double(0.0), Double(1.0));
    const Double whole = floor((at_centre - rule) * Double(1.0 / kSubpixelUnits));
    store(per_x, out.per_x[k]);
    store(per_y, out.per_y[k]);
    store(whole, out.constant[k]);
    const Double rest = at_centre - whole * Double(kSubpixelUnits);  // without the rule taken off
    if constexpr (kHasSamples) store(rest - rule, out.remainder[k]);
    if (k > 0) store(rest * inverse_area, out.weight_offset[k - 1]);
  }
}

HWY_INLINE void set_up_bounds(const Corners& c, int margin_pixels, bool upper, SetupLanes& out) {
  const PixelBounds bounds = pixel_bounds(c, margin_pixels);
  const Int low(-32768), high(32767), span = span_of(c);
  const auto half = [&](Int all) HWY_ATTR { return upper ? upper_doubles(all) : lower_doubles(all); };
  store(half(max(bounds.left, low)), out.bounds[0]);
  store(half(max(bounds.top, low)), out.bounds[1]);
  store(half(min(bounds.right, high)), out.bounds[2]);
  store(half(min(bounds.bottom, high)), out.bounds[3]);
  out.near = bits_of(half(span) <= Double(kNearSpanPixels * kSubpixelUnits));
}

HWY_INLINE hn::Vec<HalfFloatTag> half_of_floats(Int bits, bool upper) {
  const auto floats = hn::BitCast(FloatTag{}, bits.v);
  return upper ? hn::UpperHalf(HalfFloatTag{}, floats) : hn::LowerHalf(HalfFloatTag{}, floats);
}

/// 1/w relative to the largest of the three, so that no scale of w can overflow or lose a bit.
HWY_INLINE void set_up_depth(const Corners& c, bool upper, SetupLanes& out) {
  const auto half = [&](Int bits) HWY_ATTR { return Double(hn::PromoteTo(DoubleTag{}, half_of_floats(bits, upper))); };
  const Double w[3] = {half(c.w[0]), half(c.w[1]), half(c.w[2])}, z[3] = {half(c.depth[0]), half(c.depth[1]), half(c.depth[2])};
  const Double smallest = min(min(w[0], w[1]), w[2]);
  for (int k = 0; k < 3; ++k) store(max(smallest / w[k], Double(kLeastInverseW)), out.inverse_w[k]);
  store(z[0], out.depth[0]);
  store(z[1] - z[0], out.depth[1]);
  store(z[2] - z[0], out.depth[2]);
  out.affine = bits_of((w[0] == w[1]) & (w[0] == w[2]));
}

template <bool kHasSamples>
HWY_INLINE ScreenTriangle assembled(const SetupLanes& s, int lane, const TriangleArrays& t, int i) {
  ScreenTriangle out;
  for (int k = 0; k < 3; ++k) {
    out.per_x[k] = s.per_x[k][lane];
    out.per_y[k] = s.per_y[k][lane];
    out.constant[k] = s.constant[k][lane];
    out.constant_low[k] = static_cast<std::int32_t>(static_cast<std::int64_t>(s.constant[k][lane]));
    out.inverse_w[k] = s.inverse_w[k][lane];
  }
  out.weight_scale = s.weight_scale[lane];
  for (int k = 0; k < 2; ++k) {
    out.weight_offset[k] = s.weight_offset[k][lane];
    out.depth_delta[k] = s.depth[k + 1][lane];
  }
  out.depth = s.depth[0][lane];
  out.left = static_cast<std::int16_t>(s.bounds[0][lane]);
  out.top = static_cast<std::int16_t>(s.bounds[1][lane]);
  out.right = static_cast<std::int16_t>(s.bounds[2][lane]);
  out.bottom = static_cast<std::int16_t>(s.bounds[3][lane]);
  out.vertex[0] = static_cast<std::uint16_t>(t.v0[i + lane]);
  out.vertex[1] = static_cast<std::uint16_t>(t.v1[i + lane]);
  out.vertex[2] = static_cast<std::uint16_t>(t.v2[i + lane]);
  out.provoking_vertex = static_cast<std::uint16_t>(t.provoking[i + lane]);
  out.primitive = t.primitive[i + lane];
  out.perspective = (s.affine >> lane & 1u) != 0 ? kIsAffine : kDividesEachPixel;
  out.is_near = s.near >> lane & 1u;
  out.is_back = t.is_back[i + lane];
  for (int k = 0; k < 3; ++k) out.remainder[k] = kHasSamples ? static_cast<std::uint8_t>(s.remainder[k][lane]) : 0;
  return out;
}

template <bool kHasSamples>
HWY_NOINLINE void set_up_large(const Corners& corners, const TriangleArrays& t, int i, ScreenTriangle* out) {
  SetupLanes lanes;
  for (const bool upper : {false, true}) {
    const DoubleCorners half = half_of(corners, upper);
    set_up_edges<kHasSamples>(half, lanes);
    set_up_bounds(corners, kHasSamples ? 1 : 0, upper, lanes);
    set_up_depth(corners, upper, lanes);
    const int first = upper ? kDoubleLanes : 0;
    for (int lane = 0; lane < kDoubleLanes; ++lane) out[first + lane] = assembled<kHasSamples>(lanes, lane, t, i + first);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
