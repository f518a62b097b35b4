// Coverage: which pixels of a tile a triangle owns, in exact integers, and their barycentric weights.

#if defined(TUBERIA_RASTER_SIMD_RASTERIZER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_RASTERIZER_INL
#undef TUBERIA_RASTER_SIMD_RASTERIZER_INL
#else
#define TUBERIA_RASTER_SIMD_RASTERIZER_INL
#endif

#include <algorithm>
#include <cmath>

#include "raster/simd/covered_groups-inl.hpp"
#include "raster/simd/edge_arithmetic-inl.hpp"
#include "raster/simd/weight_planes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Walks the pixels of one triangle in one tile, a block at a time, a group at a time.
template <class F>
class TriangleWalk {
 public:
  /// `clip` may cut into the tile.
  HWY_INLINE TriangleWalk(const Tile& tile, const PixelRect& clip) : tile_left_(tile.left), tile_top_(tile.top) {
    const PixelRect part = intersection(clip, {tile.left, tile.top, tile.left + kTileSize, tile.top + kTileSize});
    open_ = {part.left - tile.left, part.top - tile.top, part.right - tile.left, part.bottom - tile.top};
    constexpr int kFar = 1 << 20;  // where the tile itself ends, nothing is cut
    uncut_ = {open_.left > 0 ? open_.left : -kFar, open_.top > 0 ? open_.top : -kFar, open_.right < kTileSize ? open_.right : kFar,
              open_.bottom < kTileSize ? open_.bottom : kFar};
  }

  /// Whether the triangle's bounds leave anything here. What is small is covered by cover_small; else
  /// `place` comes next, then cover_blocks.
  HWY_INLINE bool begin(const ScreenTriangle& triangle) {
    triangle_ = &triangle;
    const int left = triangle.left - tile_left_, top = triangle.top - tile_top_;
    const int right = triangle.right - tile_left_, bottom = triangle.bottom - tile_top_;
    left_ = std::max(left, open_.left);
    top_ = std::max(top, open_.top);
    right_ = std::min(right, open_.right - 1);
    bottom_ = std::min(bottom, open_.bottom - 1);
    is_near_ = triangle.is_near != 0;
    is_cut_ = left < uncut_.left || top < uncut_.top || right >= uncut_.right || bottom >= uncut_.bottom;
    return left_ <= right_ && top_ <= bottom_;
  }

  HWY_INLINE bool is_small() const { return is_near_ && right_ - left_ < kSmallPixels && bottom_ - top_ < kSmallPixels; }

  /// Places the edges. False when the triangle owns nothing here after all.
  HWY_INLINE bool place(const Tile& tile) {
    const ScreenTriangle& triangle = *triangle_;
    scale_ = F(triangle.weight_scale);
    for (int i = 0; i < 2; ++i) offset_[i] = F(triangle.weight_offset[i]);
    replaces_edges_ = false;
    if (is_near_) begin_near(triangle, tile);
    else if (!begin_far(triangle, tile)) return false;
    for (int i = 0; i < 3; ++i) edge_lanes_[i] = lane_x() * Int(per_x_[i]) + lane_y() * Int(per_y_[i]);
    return true;
  }

  /// The edges that weights come from, at the first group of a block of a near triangle, and how they grow.
  struct BlockEdges {
    Int first[2], per_column[2], per_row[2];
  };
  HWY_INLINE BlockEdges edges_of_block(int x, int y) const {
    BlockEdges edges;
    for (int i = 0; i < 2; ++i) {
      edges.first[i] = Int(at_tile_[i + 1] + per_x_[i + 1] * x + per_y_[i + 1] * y) + edge_lanes_[i + 1];
      edges.per_column[i] = Int(per_x_[i + 1] * kGroupWidth);
      edges.per_row[i] = Int(per_y_[i + 1] * kGroupHeight);
    }
    return edges;
  }
  HWY_INLINE F near_weight(int i, Int edge) const { return mul_add(to_float<F>(edge), scale_, offset_[i]); }

  HWY_INLINE bool is_near() const { return is_near_; }
  /// Bounds that leave at least half of the tile.
  HWY_INLINE bool has_much_of_tile() const { return (right_ - left_ + 1) * (bottom_ - top_ + 1) >= kTilePixels / 2; }

  /// Between which depths all fragments lie that are at (x, y) of the tile or up to `span` pixels to
  /// the right and below. Every step rounds, and keeps the order.
  HWY_INLINE void depth_bounds(int x, int y, int span, float& lowest, float& highest) const {
    lowest = highest = triangle_->depth;
    for (int i = 0; i < 2; ++i) {
      const float delta = triangle_->depth_delta[i];
      const float small = extreme_weight(i, x, y, span, false), large = extreme_weight(i, x, y, span, true);
      lowest = (delta < 0 ? large : small) * delta + lowest;
      highest = (delta < 0 ? small : large) * delta + highest;
    }
    if constexpr (contains(F::kPrecision, Precision::fused_multiply_add)) {  // lanes fuse what is done here in two steps
      const float margin = 0x1p-20f * (is_near_ ? 1.0f : planes_.magnitude()) * (std::abs(triangle_->depth) + std::abs(triangle_->depth_delta[0]) + std::abs(triangle_->depth_delta[1]));
      lowest -= margin;
      highest += margin;
    }
  }

  /// Adds every group of a small triangle with a covered pixel: its bounds are walked as they are.
  /// Calls visit.prepare(index) for each group looked at, and visit.flush() whenever the list is full.
  template <class Visit>
  HWY_INLINE void cover_small(CoveredGroups<F>& list, Visit& visit) const {
    const ScreenTriangle& t = *triangle_;
    const int first_x = left_ & ~(kGroupWidth - 1), first_y = top_ & ~(kGroupHeight - 1);
    Int row[3], step_x[3], step_y[3];
    for (int i = 0; i < 3; ++i) {
      const auto per_x = static_cast<std::uint32_t>(t.per_x[i]), per_y = static_cast<std::uint32_t>(t.per_y[i]);
      const std::uint32_t at_first = static_cast<std::uint32_t>(t.constant_low[i]) + per_x * static_cast<std::uint32_t>(tile_left_ + first_x) +
                                     per_y * static_cast<std::uint32_t>(tile_top_ + first_y);
      const Int along_x(t.per_x[i]), along_y(t.per_y[i]);
      row[i] = Int(static_cast<std::int32_t>(at_first)) + (lane_x() * along_x + lane_y() * along_y);
      step_x[i] = shift_left<kGroupWidth == 4 ? 2 : 1>(along_x);
      step_y[i] = shift_left<kGroupHeight == 4 ? 2 : 1>(along_y);
    }
    const F scale(t.weight_scale), offset1(t.weight_offset[0]), offset2(t.weight_offset[1]);
    for (int y = first_y; y <= bottom_; y += kGroupHeight) {
      Int edge[3] = {row[0], row[1], row[2]};
      for (int x = first_x; x <= right_; x += kGroupWidth) {
        Mask covered = !is_negative(edge[0] | edge[1] | edge[2]);
        if (is_cut_) covered = covered & inside_clip(x, y);
        const int index = group_index(x, y);
        visit.prepare(index);
        list.add(t, index, covered, mul_add(to_float<F>(edge[1]), scale, offset1), mul_add(to_float<F>(edge[2]), scale, offset2));
        for (int i = 0; i < 3; ++i) edge[i] = edge[i] + step_x[i];
      }
      if (list.is_full()) visit.flush();
      for (int i = 0; i < 3; ++i) row[i] = row[i] + step_y[i];
    }
  }

  /// The same of any triangle, block by block in the order of memory, since whole blocks are outside or
  /// inside; without blocks for which visit.hides(*this, x, y) or, when all their pixels are covered,
  /// visit.takes_block(*this, x, y).
  template <class Visit>
  HWY_INLINE void cover_blocks(CoveredGroups<F>& list, Visit& visit) const {
    if (replaces_edges_) [[unlikely]] return cover_blocks_by_replaced_edges(list, visit);
    for (int y = top_ & ~(kBlockSize - 1); y <= bottom_; y += kBlockSize)
      for (int x = left_ & ~(kBlockSize - 1); x <= right_; x += kBlockSize) {
        bool inside = false;
        if (is_outside(x, y, inside) || visit.hides(*this, x, y)) continue;
        if (inside && !is_cut_ && visit.takes_block(*this, x, y)) continue;
        const PixelRect part{std::max(x, left_), std::max(y, top_), std::min(x + kBlockSize - 1, right_),
                             std::min(y + kBlockSize - 1, bottom_)};
        cover(part, inside, list);
        if (list.is_full()) visit.flush();
      }
  }

 private:
  // Every value of a near triangle within its tiles fits 32 bits, so arithmetic that wraps around
  // gives it, and the low half of the constant is enough.
  HWY_INLINE void begin_near(const ScreenTriangle& triangle, const Tile& tile) {
    for (int i = 0; i < 3; ++i) {
      per_x_[i] = triangle.per_x[i];
      per_y_[i] = triangle.per_y[i];
      const auto wrapped = static_cast<std::uint32_t>(triangle.constant_low[i]) +
                           static_cast<std::uint32_t>(per_x_[i]) * static_cast<std::uint32_t>(tile.left) +
                           static_cast<std::uint32_t>(per_y_[i]) * static_cast<std::uint32_t>(tile.top);
      at_tile_[i] = static_cast<std::int32_t>(wrapped);
    }
  }

  // An edge of a far triangle that has the whole tile on its inner side, however far away, becomes
  // the constant 0; with the whole tile on its outer side, there is nothing here; an edge that
  // crosses the tile fits 32 bits.
  HWY_NOINLINE bool begin_far(const ScreenTriangle& triangle, const Tile& tile) {
    if (triangle.edge_arithmetic != EdgeArithmetic::exact) return begin_replaced(triangle, tile);
    constexpr double kSpan = kTileSize - 1;
    for (int i = 0; i < 3; ++i) {
      const double per_x = triangle.per_x[i], per_y = triangle.per_y[i];
      const double at_tile = triangle.constant[i] + per_x * tile.left + per_y * tile.top;
      const double smallest = at_tile + std::min(0.0, per_x) * kSpan + std::min(0.0, per_y) * kSpan;
      const double largest = at_tile + std::max(0.0, per_x) * kSpan + std::max(0.0, per_y) * kSpan;
      if (largest < 0) return false;
      const bool inside = smallest >= 0;
      per_x_[i] = inside ? 0 : triangle.per_x[i];
      per_y_[i] = inside ? 0 : triangle.per_y[i];
      at_tile_[i] = inside ? 0 : static_cast<std::int32_t>(at_tile);
    }

    planes_.begin(triangle, tile);
    return true;
  }

  // What rounding lets out of the bounds is cut off.
  HWY_INLINE bool begin_replaced(const ScreenTriangle& triangle, const Tile& tile) {
    for (int i = 0; i < 3; ++i) per_x_[i] = per_y_[i] = at_tile_[i] = 0;
    replaces_edges_ = is_cut_ = true;
    replaced_edges_.begin(triangle, tile);
    planes_.begin(triangle, tile);
    return true;
  }

  template <class Visit>
  HWY_NOINLINE void cover_blocks_by_replaced_edges(CoveredGroups<F>& list, Visit& visit) const {
    for (int y = top_ & ~(kBlockSize - 1); y <= bottom_; y += kBlockSize)
      for (int x = left_ & ~(kBlockSize - 1); x <= right_; x += kBlockSize) {
        bool inside = false;
        if (replaced_edges_.is_outside(x, y, kBlockSize, inside) || visit.hides(*this, x, y)) continue;
        cover_block_by_replaced_edges(x, y, inside, list);
        if (list.is_full()) visit.flush();
      }
  }

  HWY_INLINE void cover_block_by_replaced_edges(int left, int top, bool inside, CoveredGroups<F>& list) const {
    for (int y = top; y < top + kBlockSize; y += kGroupHeight)
      for (int x = left; x < left + kBlockSize; x += kGroupWidth) {
        const Mask covered = inside ? all_lanes() : replaced_edges_.covered(x, y);
        F weight[2];
        planes_.weights(planes_.columns<F>(x), planes_.rows<F>(y), weight);
        list.add(*triangle_, group_index(x, y), covered & inside_clip(x, y), weight[0], weight[1]);
      }
  }

  HWY_INLINE float extreme_weight(int i, int x, int y, int span, bool of_largest) const {
    if (!is_near_) return planes_.extreme(i, x, y, span, of_largest);
    const int per_x = per_x_[i + 1], per_y = per_y_[i + 1];
    const int at = at_tile_[i + 1] + per_x * (x + ((per_x > 0) == of_largest ? span : 0)) + per_y * (y + ((per_y > 0) == of_largest ? span : 0));
    return static_cast<float>(at) * triangle_->weight_scale + triangle_->weight_offset[i];
  }

  /// Whether the block at (x, y) lies outside an edge, and if not, whether it lies inside all.
  HWY_INLINE bool is_outside(int x, int y, bool& inside) const {
    constexpr int kSpan = kBlockSize - 1;
    inside = true;
    for (int i = 0; i < 3; ++i) {
      const std::int32_t at_block = at_tile_[i] + per_x_[i] * x + per_y_[i] * y;
      if (at_block + kSpan * (std::max(0, per_x_[i]) + std::max(0, per_y_[i])) < 0) return true;
      inside &= at_block + kSpan * (std::min(0, per_x_[i]) + std::min(0, per_y_[i])) >= 0;
    }
    return false;
  }

  /// The groups of a part of a block (right and bottom inclusive here).
  HWY_INLINE void cover(const PixelRect& part, bool inside, CoveredGroups<F>& list) const {
    const int first_x = part.left & ~(kGroupWidth - 1), first_y = part.top & ~(kGroupHeight - 1);
    Int row[3], step_x[3], step_y[3];
    for (int i = 0; i < 3; ++i) {
      row[i] = Int(at_tile_[i] + per_x_[i] * first_x + per_y_[i] * first_y) + edge_lanes_[i];
      step_x[i] = Int(per_x_[i] * kGroupWidth);
      step_y[i] = Int(per_y_[i] * kGroupHeight);
    }
    for (int y = first_y; y <= part.bottom; y += kGroupHeight) {
      Int edge[3] = {row[0], row[1], row[2]};
      for (int x = first_x; x <= part.right; x += kGroupWidth) {
        Mask covered = inside ? all_lanes() : !is_negative(edge[0] | edge[1] | edge[2]);
        if (is_cut_) covered = covered & inside_clip(x, y);
        F weight[2];
        find_weights(edge, x, y, weight);
        list.add(*triangle_, group_index(x, y), covered, weight[0], weight[1]);
        for (int i = 0; i < 3; ++i) edge[i] = edge[i] + step_x[i];
      }
      for (int i = 0; i < 3; ++i) row[i] = row[i] + step_y[i];
    }
  }

  HWY_INLINE Mask inside_clip(int x, int y) const {
    const Int column = lane_x() + Int(x), line = lane_y() + Int(y);
    return !((column < Int(left_)) | (column > Int(right_)) | (line < Int(top_)) | (line > Int(bottom_)));
  }

  HWY_INLINE void find_weights(const Int* edge, int x, int y, F* weight) const {
    if (is_near_) {
      for (int i = 0; i < 2; ++i) weight[i] = mul_add(to_float<F>(edge[i + 1]), scale_, offset_[i]);
      return;
    }
    planes_.weights(planes_.columns<F>(x), planes_.rows<F>(y), weight);
  }

  int tile_left_, tile_top_;
  PixelRect open_;     // what the clip leaves of the tile, in its pixels
  PixelRect uncut_;    // where no triangle is cut by the clip
  const ScreenTriangle* triangle_ = nullptr;
  int left_, top_, right_, bottom_;  // pixels of the tile, inclusive
  bool is_cut_, is_near_;
  std::int32_t per_x_[3], per_y_[3], at_tile_[3];
  Int edge_lanes_[3];
  F scale_, offset_[2];
  WeightPlanes planes_;
  bool replaces_edges_ = false;
  ReplacedEdges replaced_edges_;
};

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
