// Edge functions in other arithmetic than the usual one: in 64 bits everywhere, which is as exact and
// slower, or in floats, as many rasterizers compute them, which is not exact.

#if defined(TUBERIA_RASTER_SIMD_EDGE_ARITHMETIC_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_EDGE_ARITHMETIC_INL
#undef TUBERIA_RASTER_SIMD_EDGE_ARITHMETIC_INL
#else
#define TUBERIA_RASTER_SIMD_EDGE_ARITHMETIC_INL
#endif

#include <algorithm>

#include "raster/simd/double-inl.hpp"
#include "raster/simd/number-inl.hpp"
#include "raster/tile.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// The record's edge functions, start + per_x columns + per_y rows, where columns and rows count from
/// pixel (0, 0) of the target or from the corner of the 64x64 square that holds the tile. Every step
/// is rounded by itself, in both precisions, so both cover the same pixels.
class ReplacedEdges {
 public:
  HWY_INLINE void begin(const ScreenTriangle& t, const Tile& tile) {
    const bool is_anchored = t.edge_arithmetic != EdgeArithmetic::float_plane;
    const int corner_x = is_anchored ? tile.left & ~(kAnchorSquarePixels - 1) : 0, corner_y = is_anchored ? tile.top & ~(kAnchorSquarePixels - 1) : 0;
    is_wide_ = t.edge_arithmetic == EdgeArithmetic::exact_64;
    column_ = tile.left - corner_x;
    row_ = tile.top - corner_y;
    for (int i = 0; i < 3; ++i) {
      wide_[i] = t.constant[i] + static_cast<double>(t.per_x[i]) * corner_x + static_cast<double>(t.per_y[i]) * corner_y;
      start_[i] = static_cast<float>(wide_[i]);
      per_x_[i] = static_cast<float>(t.per_x[i]);
      per_y_[i] = static_cast<float>(t.per_y[i]);
    }
  }

  /// Whether the square of pixels at (x, y) of the tile lies outside an edge, and if not, whether it
  /// lies inside all. Rounding keeps the order, so its corners tell.
  HWY_INLINE bool is_outside(int x, int y, int size, bool& inside) const {
    inside = true;
    for (int i = 0; i < 3; ++i) {
      const int right = size - 1, last_x = per_x_[i] > 0 ? right : 0, last_y = per_y_[i] > 0 ? right : 0;
      if (at(i, x + last_x, y + last_y) < 0) return true;
      inside &= at(i, x + right - last_x, y + right - last_y) >= 0;
    }
    return false;
  }

  /// The covered pixels of the group whose first one is (x, y) of the tile.
  HWY_INLINE Mask covered(int x, int y) const {
    const Int columns = lane_x() + Int(x + column_), rows = lane_y() + Int(y + row_);
    return is_wide_ ? covered_in_64_bits(columns, rows) : covered_in_floats(to_float<ExactFloat>(columns), to_float<ExactFloat>(rows));
  }

 private:
  HWY_INLINE double at(int i, int x, int y) const {
    if (is_wide_) return static_cast<double>(per_y_[i]) * (y + row_) + (static_cast<double>(per_x_[i]) * (x + column_) + wide_[i]);
    const float across = static_cast<float>(x + column_) * per_x_[i] + start_[i];
    return static_cast<double>(static_cast<float>(y + row_) * per_y_[i] + across);
  }

  HWY_INLINE Mask covered_in_floats(ExactFloat columns, ExactFloat rows) const {
    Mask inside = all_lanes();
    for (int i = 0; i < 3; ++i) inside = inside & (rows * per_y_[i] + (columns * per_x_[i] + start_[i]) >= 0.0f);
    return inside;
  }

  /// Doubles hold the whole numbers exactly.
  HWY_INLINE Mask covered_in_64_bits(Int columns, Int rows) const {
    std::uint32_t bits = 0;
    for (const bool upper : {false, true}) {
      const auto half = [upper](Int a) HWY_ATTR {
        return Double(hn::PromoteTo(DoubleTag{}, upper ? hn::UpperHalf(HalfIntTag{}, a.v) : hn::LowerHalf(HalfIntTag{}, a.v)));
      };
      const Double x = half(columns), y = half(rows);
      DoubleMask outside = Double(1.0) < Double(0.0);
      for (int i = 0; i < 3; ++i)
        outside = outside | (y * Double(static_cast<double>(per_y_[i])) + (x * Double(static_cast<double>(per_x_[i])) + Double(wide_[i])) < Double(0.0));
      bits |= bits_of(!outside) << (upper ? kDoubleLanes : 0);
    }
    return mask_of(bits);
  }

  bool is_wide_ = false;
  int column_ = 0, row_ = 0;  // of the tile, from where the edges start
  float start_[3], per_x_[3], per_y_[3];  // slopes are whole and at most 2^24: exact in floats
  double wide_[3];
};

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
