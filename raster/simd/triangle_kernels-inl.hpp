// Triangles in bulk: culling by the exact area, and setup.

#if defined(TUBERIA_RASTER_SIMD_TRIANGLE_KERNELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_TRIANGLE_KERNELS_INL
#undef TUBERIA_RASTER_SIMD_TRIANGLE_KERNELS_INL
#else
#define TUBERIA_RASTER_SIMD_TRIANGLE_KERNELS_INL
#endif

#include <algorithm>
#include <utility>

#include "math/fixed_point.hpp"
#include "raster/geometry_kernels.hpp"
#include "raster/simd/double-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// The corners of as many triangles as a register has doubles; 24.8 units are exact in them, and
/// so are their products and the sums of two.
struct Corners {
  Double x[3], y[3];
};

HWY_INLINE Corners gather_corners(const TriangleArrays& t, int i, const ScreenArrays& vertices) {
  const std::uint32_t* slots[3] = {t.v0 + i, t.v1 + i, t.v2 + i};
  Corners c;
  for (int k = 0; k < 3; ++k) {
    c.x[k] = gather_double(vertices.x, slots[k]);
    c.y[k] = gather_double(vertices.y, slots[k]);
  }
  return c;
}

/// Twice the signed area, positive for clockwise on the screen; |.| <= 2^49, exact.
HWY_INLINE Double twice_area(const Corners& c) {
  return (c.x[1] - c.x[0]) * (c.y[2] - c.y[0]) - (c.y[1] - c.y[0]) * (c.x[2] - c.x[0]);
}

/// The pixels whose centres lie within the bounds of the corners, or less than a margin beside them;
/// inclusive.
struct PixelBounds {
  Double left, top, right, bottom;
};

HWY_INLINE PixelBounds pixel_bounds(const Corners& c, int margin_pixels) {
  const double margin = margin_pixels * kSubpixelUnits;
  const Double unit(1.0 / kSubpixelUnits), low_centre(kPixelCentre + margin), high_centre(kPixelCentre - margin);
  const auto first = [&](const Double* v) HWY_ATTR {  // ceil, by way of floor
    return Double(0.0) - floor((low_centre - min(min(v[0], v[1]), v[2])) * unit);
  };
  const auto last = [&](const Double* v) HWY_ATTR { return floor((max(max(v[0], v[1]), v[2]) - high_centre) * unit); };
  return {first(c.x), first(c.y), last(c.x), last(c.y)};
}

inline int cull(const TriangleArrays& triangles, int count, const ScreenArrays& vertices, const CullOptions& options,
                const PixelRect& clip) {
  // Bytes may alias anything; what lies in variables of our own need not be read again after each.
  const TriangleArrays t = triangles;
  const bool turned_is_back = options.counter_clockwise_is_back;
  int kept = 0;
  for (int i = 0; i < count; i += kDoubleLanes) {
    const Corners corners = gather_corners(t, i, vertices);
    const Double area = twice_area(corners);
    const PixelBounds bounds = pixel_bounds(corners, options.margin_pixels);
    const DoubleMask holds_a_centre = (max(bounds.left, Double(clip.left)) <= min(bounds.right, Double(clip.right - 1))) &
                                      (max(bounds.top, Double(clip.top)) <= min(bounds.bottom, Double(clip.bottom - 1)));
    const std::uint32_t counter_clockwise = bits_of(area < Double(0.0));
    std::uint32_t keep = 0;
    if (options.keep_clockwise) keep |= bits_of(area > Double(0.0));
    if (options.keep_counter_clockwise) keep |= counter_clockwise;
    keep &= bits_of(holds_a_centre);

    // Lists are copied forward in order; the loop never overtakes its reading.
    const int lanes = std::min(kDoubleLanes, count - i);
    for (int lane = 0; lane < lanes; ++lane) {
      if ((keep >> lane & 1u) == 0) continue;
      const int from = i + lane;
      const bool swap = (counter_clockwise >> lane & 1u) != 0;
      const std::uint32_t v1 = t.v1[from], v2 = t.v2[from];
      t.v0[kept] = t.v0[from];
      t.v1[kept] = swap ? v2 : v1;
      t.v2[kept] = swap ? v1 : v2;
      t.provoking[kept] = t.provoking[from];
      t.primitive[kept] = t.primitive[from];
      t.is_back[kept] = swap == turned_is_back;
      ++kept;
    }
  }
  return kept;
}

/// A register's worth of set-up triangles, field by field.
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
HWY_INLINE void set_up_edges(const Corners& c, SetupLanes& out) {
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

HWY_INLINE void set_up_bounds(const Corners& c, int margin_pixels, SetupLanes& out) {
  const PixelBounds bounds = pixel_bounds(c, margin_pixels);
  const Double low(-32768.0), high(32767.0);
  store(max(bounds.left, low), out.bounds[0]);
  store(max(bounds.top, low), out.bounds[1]);
  store(min(bounds.right, high), out.bounds[2]);
  store(min(bounds.bottom, high), out.bounds[3]);
  const auto span = [&](const Double* v) HWY_ATTR { return max(max(v[0], v[1]), v[2]) - min(min(v[0], v[1]), v[2]); };
  out.near = bits_of(max(span(c.x), span(c.y)) <= Double(kNearSpanPixels * kSubpixelUnits));
}

/// 1/w relative to the largest of the three, so that no scale of w can overflow or lose a bit.
HWY_INLINE void set_up_depth(const TriangleArrays& t, int i, const float* depth, const float* clip_w, SetupLanes& out) {
  const std::uint32_t* slots[3] = {t.v0 + i, t.v1 + i, t.v2 + i};
  Double w[3], z[3];
  for (int k = 0; k < 3; ++k) {
    w[k] = gather_double(clip_w, slots[k]);
    z[k] = gather_double(depth, slots[k]);
  }
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
  out.is_affine = s.affine >> lane & 1u;
  out.is_near = s.near >> lane & 1u;
  out.is_back = t.is_back[i + lane];
  for (int k = 0; k < 3; ++k) out.remainder[k] = kHasSamples ? static_cast<std::uint8_t>(s.remainder[k][lane]) : 0;
  return out;
}

template <bool kHasSamples>
void set_up_all(const TriangleArrays& t, int count, const ScreenArrays& vertices, const float* clip_w, ScreenTriangle* out) {
  SetupLanes lanes;
  for (int i = 0; i < count; i += kDoubleLanes) {
    const Corners corners = gather_corners(t, i, vertices);
    set_up_edges<kHasSamples>(corners, lanes);
    set_up_bounds(corners, kHasSamples ? 1 : 0, lanes);
    set_up_depth(t, i, vertices.depth, clip_w, lanes);
    for (int lane = 0; lane < std::min(kDoubleLanes, count - i); ++lane) out[i + lane] = assembled<kHasSamples>(lanes, lane, t, i);
  }
}

inline void set_up(const TriangleArrays& t, int count, const ScreenArrays& vertices, const float* clip_w,
                   bool has_samples, ScreenTriangle* out) {
  if (has_samples) set_up_all<true>(t, count, vertices, clip_w, out);
  else set_up_all<false>(t, count, vertices, clip_w, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
