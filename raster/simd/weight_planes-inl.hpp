// Barycentric weights of triangles too large to take them from 32-bit edge functions.

#if defined(TUBERIA_RASTER_SIMD_WEIGHT_PLANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_WEIGHT_PLANES_INL
#undef TUBERIA_RASTER_SIMD_WEIGHT_PLANES_INL
#else
#define TUBERIA_RASTER_SIMD_WEIGHT_PLANES_INL
#endif

#include <algorithm>
#include <cmath>

#include "raster/simd/number-inl.hpp"
#include "raster/tile.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// The weights of a far triangle: planes anchored at the corner of the pixel grid's square that holds
/// the tile, in double, rounded once.
struct WeightPlanes {
  int tile_x = 0, tile_y = 0;  // the tile in its square, pixels
  float anchor[2] = {}, gradient_x[2] = {}, gradient_y[2] = {};

  HWY_INLINE void begin(const ScreenTriangle& triangle, const Tile& tile) {
    const int corner_x = tile.left & ~(kAnchorSquarePixels - 1), corner_y = tile.top & ~(kAnchorSquarePixels - 1);
    tile_x = tile.left - corner_x;
    tile_y = tile.top - corner_y;
    const double scale = triangle.weight_scale;
    for (int i = 0; i < 2; ++i) {
      const double per_x = triangle.per_x[i + 1], per_y = triangle.per_y[i + 1];
      const double at_corner = triangle.constant[i + 1] + per_x * corner_x + per_y * corner_y;
      anchor[i] = static_cast<float>(at_corner * scale + triangle.weight_offset[i]);
      gradient_x[i] = static_cast<float>(per_x * scale);
      gradient_y[i] = static_cast<float>(per_y * scale);
    }
  }

  /// Columns and rows of the group whose first pixel is (x, y) of the tile, from the square's corner.
  template <class F>
  HWY_INLINE F columns(int x) const { return to_float<F>(lane_x() + Int(x + tile_x)); }
  template <class F>
  HWY_INLINE F rows(int y) const { return to_float<F>(lane_y() + Int(y + tile_y)); }
  template <class F>
  HWY_INLINE void weights(F dx, F dy, F* weight) const {
    for (int i = 0; i < 2; ++i) weight[i] = mul_add(dy, F(gradient_y[i]), mul_add(dx, F(gradient_x[i]), F(anchor[i])));
  }

  /// Above any number that `weights` comes across on its way: what its roundings are in proportion to.
  HWY_INLINE float magnitude() const {
    float largest = 1;
    for (int i = 0; i < 2; ++i)
      largest = std::max(largest, std::abs(anchor[i]) + kAnchorSquarePixels * (std::abs(gradient_x[i]) + std::abs(gradient_y[i])));
    return largest;
  }

  /// The smallest (of_largest: the largest) that `weights` gives for weight i in a square of the tile.
  /// Each rounding keeps the order, so it is found at a corner.
  HWY_INLINE float extreme(int i, int x, int y, int span, bool of_largest) const {
    const int dx = x + tile_x + ((gradient_x[i] > 0) == of_largest ? span : 0);
    const int dy = y + tile_y + ((gradient_y[i] > 0) == of_largest ? span : 0);
    return static_cast<float>(dy) * gradient_y[i] + (static_cast<float>(dx) * gradient_x[i] + anchor[i]);
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
