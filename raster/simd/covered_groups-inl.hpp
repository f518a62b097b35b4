// Groups of covered pixels: what coverage hands on.

#if defined(TUBERIA_RASTER_SIMD_COVERED_GROUPS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_COVERED_GROUPS_INL
#undef TUBERIA_RASTER_SIMD_COVERED_GROUPS_INL
#else
#define TUBERIA_RASTER_SIMD_COVERED_GROUPS_INL
#endif

#include "raster/simd/number-inl.hpp"
#include "raster/tile.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

// A group is the pixels of one register: 2x2, 4x2 or 4x4 of them.
inline constexpr int kGroupWidth = kLanes >= 8 ? 4 : 2;
inline constexpr int kGroupHeight = kLanes / kGroupWidth;

/// Where in a tile's memory the group begins whose first pixel is (x, y): index_in_tile for multiples of
/// the group's size.
HWY_INLINE int group_index(int x, int y) {
  const int block = (y / kBlockSize * kBlocksPerTileRow + x / kBlockSize) * kBlockPixels;
  const int column = (x & 4) << 2 | (kGroupWidth < 4 ? (x & 2) << 1 : 0), row = (y & 4) << 3 | (kGroupHeight < 4 ? (y & 2) << 2 : 0);
  return block + column + row;
}

/// One register of pixels with at least one that is covered.
template <class F>
struct FragmentGroup {
  int index;            // of its first pixel in the tile's memory
  Mask covered;
  F weight[2];          // barycentric weights of vertices 1 and 2, linear in screen space
};

/// Groups on their way from coverage to the rest of the pipeline, of one triangle after the other.
/// Coverage in one loop and what follows in another keeps the registers of both, and which groups are
/// covered is no jump.
template <class F>
class CoveredGroups {
 public:
  static constexpr int kMost = 32;
  static constexpr int kMostAtOnce = 16;  // a block of the narrowest machine, or a row of a small triangle

  bool is_full() const { return count_ > kMost - kMostAtOnce; }
  int count() const { return count_; }
  const ScreenTriangle& triangle(int i) const { return *triangle_[i]; }
  HWY_INLINE FragmentGroup<F> group(int i) const { return {index_[i], mask_of(covered_[i]), {load<F>(weight_[i][0]), load<F>(weight_[i][1])}}; }
  void clear() { count_ = 0; }

  /// Keeps the group if it has a covered pixel.
  HWY_INLINE void add(const ScreenTriangle& triangle, int index, Mask covered, F weight1, F weight2) {
    triangle_[count_] = &triangle;
    index_[count_] = index;
    covered_[count_] = bits_of(covered);
    store(weight1, weight_[count_][0]);
    store(weight2, weight_[count_][1]);
    count_ += covered_[count_] != 0 ? 1 : 0;
  }

 private:
  int count_ = 0;
  const ScreenTriangle* triangle_[kMost];
  int index_[kMost];
  std::uint32_t covered_[kMost];
  alignas(64) float weight_[kMost][2][kLanes];
};

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
