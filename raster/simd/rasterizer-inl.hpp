// Coverage: which pixels of a tile a triangle owns, in exact integers, and their barycentric weights.

#if defined(TUBERIA_RASTER_SIMD_RASTERIZER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_RASTERIZER_INL
#undef TUBERIA_RASTER_SIMD_RASTERIZER_INL
#else
#define TUBERIA_RASTER_SIMD_RASTERIZER_INL
#endif

#include <algorithm>

#include "raster/simd/number-inl.hpp"
#include "raster/tile.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

// A group is the pixels of one register: 2 rows of kGroupWidth.
inline constexpr int kGroupWidth = kLanes / 2;
inline constexpr int kGroupHeight = 2;
inline constexpr int kGroupsPerBlock = kBlockPixels / kLanes;
inline constexpr int kGroupsPerBlockRow = kBlockSize / kGroupWidth;

/// One register of pixels with at least one that is covered.
template <class F>
struct FragmentGroup {
  int index;            // of its first pixel in the tile's memory
  Mask covered;
  F weight[2];          // barycentric weights of vertices 1 and 2, linear in screen space
};

/// Walks the pixels of one triangle in one tile, a block at a time, a group at a time.
template <class F>
class TriangleWalk {
 public:
  /// False when the triangle owns nothing here. `clip` may cut into the tile.
  HWY_INLINE bool begin(const ScreenTriangle& triangle, const Tile& tile, const PixelRect& clip) {
    triangle_ = &triangle;
    left_ = std::max<int>(std::max<int>(triangle.left, clip.left), tile.left) - tile.left;
    top_ = std::max<int>(std::max<int>(triangle.top, clip.top), tile.top) - tile.top;
    right_ = std::min<int>(std::min<int>(triangle.right, clip.right - 1), tile.left + kTileSize - 1) - tile.left;
    bottom_ = std::min<int>(std::min<int>(triangle.bottom, clip.bottom - 1), tile.top + kTileSize - 1) - tile.top;
    if (left_ > right_ || top_ > bottom_) return false;
    is_cut_ = triangle.left < clip.left || triangle.top < clip.top || triangle.right >= clip.right ||
              triangle.bottom >= clip.bottom;
    for (int i = 0; i < 3; ++i)
      if (!begin_edge(i, tile)) return false;
    begin_weights(tile);
    return true;
  }

  /// Calls visit(group) for every group with a covered pixel.
  template <class Visit>
  HWY_INLINE void for_each_group(Visit& visit) const {
    for (int y = top_ & ~(kBlockSize - 1); y <= bottom_; y += kBlockSize)
      for (int x = left_ & ~(kBlockSize - 1); x <= right_; x += kBlockSize) walk_block(x, y, visit);
  }

 private:
  // An edge's value at the tile's first pixel, in 32 bits. An edge that has the whole tile on its
  // inner side, however far away, becomes the constant 0; on its outer side, there is nothing here.
  HWY_INLINE bool begin_edge(int i, const Tile& tile) {
    const double at_tile = triangle_->constant[i] + static_cast<double>(triangle_->per_x[i]) * tile.left +
                           static_cast<double>(triangle_->per_y[i]) * tile.top;
    per_x_[i] = triangle_->per_x[i];
    per_y_[i] = triangle_->per_y[i];
    if (!triangle_->is_near) {
      constexpr double kSpan = kTileSize - 1;
      const double smallest = at_tile + std::min(0, per_x_[i]) * kSpan + std::min(0, per_y_[i]) * kSpan;
      const double largest = at_tile + std::max(0, per_x_[i]) * kSpan + std::max(0, per_y_[i]) * kSpan;
      if (largest < 0) return false;
      if (smallest >= 0) {
        per_x_[i] = per_y_[i] = at_tile_[i] = 0;
        set_edge_lanes(i);
        return true;
      }
    }
    at_tile_[i] = static_cast<std::int32_t>(at_tile);
    set_edge_lanes(i);
    return true;
  }

  HWY_INLINE void set_edge_lanes(int i) {
    edge_lanes_[i] = lane_x() * Int(per_x_[i]) + lane_y() * Int(per_y_[i]);
    largest_in_block_[i] = (kBlockSize - 1) * (std::max(0, per_x_[i]) + std::max(0, per_y_[i]));
    smallest_in_block_[i] = (kBlockSize - 1) * (std::min(0, per_x_[i]) + std::min(0, per_y_[i]));
  }

  HWY_INLINE void begin_weights(const Tile& tile) {
    scale_ = F(triangle_->weight_scale);
    for (int i = 0; i < 2; ++i) offset_[i] = F(triangle_->weight_offset[i]);
    if (triangle_->is_near) return;

    // A plane anchored at the corner of the pixel grid's square: in double, rounded once.
    const int corner_x = tile.left & ~(kAnchorSquarePixels - 1), corner_y = tile.top & ~(kAnchorSquarePixels - 1);
    tile_in_square_x_ = tile.left - corner_x;
    tile_in_square_y_ = tile.top - corner_y;
    const double scale = triangle_->weight_scale;
    for (int i = 0; i < 2; ++i) {
      const double per_x = triangle_->per_x[i + 1], per_y = triangle_->per_y[i + 1];
      const double at_corner = triangle_->constant[i + 1] + per_x * corner_x + per_y * corner_y;
      anchor_[i] = static_cast<float>(at_corner * scale + triangle_->weight_offset[i]);
      gradient_x_[i] = static_cast<float>(per_x * scale);
      gradient_y_[i] = static_cast<float>(per_y * scale);
    }
  }

  template <class Visit>
  HWY_INLINE void walk_block(int x, int y, Visit& visit) const {
    // Whole-block decisions first: outside one edge, or inside all three.
    std::int32_t at_block[3];
    bool inside = true;
    for (int i = 0; i < 3; ++i) {
      at_block[i] = at_tile_[i] + per_x_[i] * x + per_y_[i] * y;
      if (at_block[i] + largest_in_block_[i] < 0) return;
      inside &= at_block[i] + smallest_in_block_[i] >= 0;
    }

    const int block_index = ((y / kBlockSize) * kBlocksPerTileRow + x / kBlockSize) * kBlockPixels;
    Int row[3];
    const int first_y = std::max(top_ - y, 0) & ~1, last_y = std::min(bottom_ - y, kBlockSize - 1);
    const int first_x = std::max(left_ - x, 0) & ~(kGroupWidth - 1), last_x = std::min(right_ - x, kBlockSize - 1);
    for (int i = 0; i < 3; ++i)
      row[i] = Int(at_block[i] + per_x_[i] * first_x + per_y_[i] * first_y) + edge_lanes_[i];
    for (int group_y = first_y; group_y <= last_y; group_y += kGroupHeight) {
      Int edge[3] = {row[0], row[1], row[2]};
      for (int group_x = first_x; group_x <= last_x; group_x += kGroupWidth) {
        Mask covered = inside ? all_lanes() : !is_negative(edge[0] | edge[1] | edge[2]);
        if (is_cut_) covered = covered & inside_clip(x + group_x, y + group_y);
        if (any(covered)) {
          FragmentGroup<F> group;
          group.index = block_index + ((group_y / 2) * kGroupsPerBlockRow + group_x / kGroupWidth) * kLanes;
          group.covered = covered;
          set_weights(group, edge, x + group_x, y + group_y);
          visit(group);
        }
        if constexpr (kGroupsPerBlockRow > 1)
          for (int i = 0; i < 3; ++i) edge[i] = edge[i] + Int(per_x_[i] * kGroupWidth);
      }
      for (int i = 0; i < 3; ++i) row[i] = row[i] + Int(per_y_[i] * kGroupHeight);
    }
  }

  HWY_INLINE Mask inside_clip(int x, int y) const {
    const Int column = lane_x() + Int(x), line = lane_y() + Int(y);
    return !((column < Int(left_)) | (column > Int(right_)) | (line < Int(top_)) | (line > Int(bottom_)));
  }

  HWY_INLINE void set_weights(FragmentGroup<F>& group, const Int* edge, int x, int y) const {
    if (triangle_->is_near) {
      for (int i = 0; i < 2; ++i) group.weight[i] = mul_add(to_float<F>(edge[i + 1]), scale_, offset_[i]);
      return;
    }
    const F dx = to_float<F>(lane_x() + Int(x + tile_in_square_x_));
    const F dy = to_float<F>(lane_y() + Int(y + tile_in_square_y_));
    for (int i = 0; i < 2; ++i)
      group.weight[i] = mul_add(dy, F(gradient_y_[i]), mul_add(dx, F(gradient_x_[i]), F(anchor_[i])));
  }

  const ScreenTriangle* triangle_;
  int left_, top_, right_, bottom_;  // pixels of the tile, inclusive
  bool is_cut_;
  std::int32_t per_x_[3], per_y_[3], at_tile_[3];
  std::int32_t largest_in_block_[3], smallest_in_block_[3];
  Int edge_lanes_[3];
  F scale_, offset_[2];
  int tile_in_square_x_ = 0, tile_in_square_y_ = 0;
  float anchor_[2] = {}, gradient_x_[2] = {}, gradient_y_[2] = {};
};

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
