// Culling in bulk, by the exact area and the exact coverage.

#if defined(TUBERIA_RASTER_SIMD_CULLING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_CULLING_INL
#undef TUBERIA_RASTER_SIMD_CULLING_INL
#else
#define TUBERIA_RASTER_SIMD_CULLING_INL
#endif

#include <algorithm>
#include <bit>

#include "raster/simd/corners-inl.hpp"
#include "raster/simd/packing-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Which way triangles run on the screen, a bit each; those without area neither way.
struct Windings {
  std::uint32_t clockwise, counter_clockwise;
};

HWY_INLINE Windings windings_of(const Corners& c, Mask is_small, Int area_if_small) {
  if (all(is_small)) return {bits_of(area_if_small > Int(0)), bits_of(area_if_small < Int(0))};
  const Double lower = twice_area(half_of(c, false)), upper = twice_area(half_of(c, true)), none(0.0);
  return {bits_of(lower > none) | bits_of(upper > none) << kDoubleLanes, bits_of(lower < none) | bits_of(upper < none) << kDoubleLanes};
}

/// How many pixels the search for a covered centre looks at in x and in y. (3: no faster in any frame.)
inline constexpr int kSearchedPixels = 2;

/// Of small triangles that run clockwise: whether they cover the centre of a pixel from (x, y) to
/// (x + columns - 1, y + rows - 1), for up to kSearchedPixels columns and rows.
HWY_INLINE Mask covers_a_centre(const Corners& c, const EdgeValues& edges, Int columns, Int rows) {
  Int edge[3], per_x[3], per_y[3];
  for (int k = 0; k < 3; ++k) {
    const int from = (k + 1) % 3, to = (k + 2) % 3;
    const Int slope_x = c.y[from] - c.y[to], slope_y = c.x[to] - c.x[from];
    edge[k] = edges.at[k] + top_left_rule(slope_x, slope_y);
    per_x[k] = shift_left<kSubpixelBits>(slope_x);
    per_y[k] = shift_left<kSubpixelBits>(slope_y);
  }
  Mask covered = mask_of(0);
  for (int row = 0; row < kSearchedPixels; ++row) {
    Int here[3] = {edge[0], edge[1], edge[2]};
    for (int column = 0; column < kSearchedPixels; ++column) {
      const Mask outside = is_negative(here[0] | here[1] | here[2]);
      covered = covered | ((!outside) & (columns > Int(column)) & (rows > Int(row)));
      for (int k = 0; k < 3; ++k) here[k] = here[k] + per_x[k];
    }
    for (int k = 0; k < 3; ++k) edge[k] = edge[k] + per_y[k];
  }
  return covered;
}

/// The same triangles, clockwise.
HWY_INLINE void turn(Corners& c, EdgeValues& edges, Mask counter_clockwise) {
  const auto exchange = [&](Int (&v)[3]) HWY_ATTR {
    const Int first = v[1];
    v[1] = select(counter_clockwise, v[2], v[1]);
    v[2] = select(counter_clockwise, first, v[2]);
  };
  exchange(c.x);
  exchange(c.y);
  exchange(edges.at);
  for (Int& value : edges.at) value = select(counter_clockwise, Int(0) - value, value);
}

/// Copies the chosen triangles of register i to the list's new end, clockwise.
HWY_INLINE void move_triangles(const TriangleArrays& t, int i, int to, std::uint32_t chosen, std::uint32_t counter_clockwise,
                               bool counter_clockwise_is_back) {
  const LanePacking packed(chosen);
  const auto move = [&](Int value, std::uint32_t* array) HWY_ATTR { store(packed(value), array + to); };
  const Mask swap = mask_of(counter_clockwise);
  const Int v1 = load(t.v1 + i), v2 = load(t.v2 + i);
  move(load(t.v0 + i), t.v0);
  move(select(swap, v2, v1), t.v1);
  move(select(swap, v1, v2), t.v2);
  move(load(t.provoking + i), t.provoking);
  move(load(t.primitive + i), t.primitive);
  const Int is_back = select(swap, Int(counter_clockwise_is_back ? 1 : 0), Int(counter_clockwise_is_back ? 0 : 1));
  store_narrow(packed(is_back), t.is_back + to);
}

inline CullResult cull(const TriangleArrays& t, int count, const ScreenVertex* vertices, const CullOptions& options,
                       const PixelRect& clip) {
  CullResult result;
  const bool searches = options.margin_pixels == 0;
  for (int i = 0; i < count; i += kLanes) {
    Corners corners = load_corners(t, i, vertices);
    const PixelBounds bounds = pixel_bounds(corners, options.margin_pixels);
    const Int left = max(bounds.left, Int(clip.left)), top = max(bounds.top, Int(clip.top));
    const Int columns = min(bounds.right, Int(clip.right - 1)) - left + Int(1);
    const Int rows = min(bounds.bottom, Int(clip.bottom - 1)) - top + Int(1);
    const Mask holds_a_centre = (columns > Int(0)) & (rows > Int(0));
    const int lanes = std::min(kLanes, count - i);
    std::uint32_t keep = bits_of(holds_a_centre) & ((1u << lanes) - 1);
    if (keep == 0) continue;

    const Mask is_small = span_of(corners) < Int(kSmallSpanUnits);
    EdgeValues edges = edges_at(corners, left, top);
    const Windings windings = windings_of(corners, is_small, edges.twice_area());
    keep &= (options.keep_clockwise ? windings.clockwise : 0u) | (options.keep_counter_clockwise ? windings.counter_clockwise : 0u);
    if (keep == 0) continue;

    if (searches) {
      const Mask can_be_searched = is_small & (columns < Int(kSearchedPixels + 1)) & (rows < Int(kSearchedPixels + 1));
      turn(corners, edges, mask_of(windings.counter_clockwise));
      const std::uint32_t uncovered = keep & bits_of(can_be_searched & (!covers_a_centre(corners, edges, columns, rows)));
      result.uncovered += std::popcount(uncovered);
      keep &= ~uncovered;
    }
    // Lists are copied forward in order; the loop never overtakes its reading.
    move_triangles(t, i, result.kept, keep, windings.counter_clockwise, options.counter_clockwise_is_back);
    result.kept += std::popcount(keep);
  }
  return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
