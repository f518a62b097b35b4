// Coverage, weights and depths where each pixel of the target has several samples: docs/machine.md.

#if defined(TUBERIA_RASTER_SIMD_MULTISAMPLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_MULTISAMPLE_INL
#undef TUBERIA_RASTER_SIMD_MULTISAMPLE_INL
#else
#define TUBERIA_RASTER_SIMD_MULTISAMPLE_INL
#endif

#include <algorithm>

#include "raster/simd/interpolation-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// A triangle's edge functions at one sample of each pixel of a tile: those at the centres, moved.
struct SampleEdges {
  std::int32_t at_tile[3];  // at the tile's first pixel
  bool inside[3];           // the whole tile is inside: of far triangles the edge counts as 0
  bool is_in_tile;          // no edge has the whole tile outside
  float offset[2];          // of the weights of near triangles
  float right, down;        // of the centre, in pixels

  HWY_INLINE void begin(const ScreenTriangle& t, const Tile& tile, SamplePosition position) {
    constexpr std::int64_t kSpan = kTileSize - 1;
    is_in_tile = true;
    right = static_cast<float>(position.x) * 0x1p-4f;
    down = static_cast<float>(position.y) * 0x1p-4f;
    for (int i = 0; i < 3; ++i) {
      const std::int64_t per_x = t.per_x[i], per_y = t.per_y[i];
      const std::int64_t moved = t.remainder[i] + (per_x * position.x + per_y * position.y) * kUnitsPerSampleStep;
      const std::int64_t at = static_cast<std::int64_t>(t.constant[i]) + (moved >> 8) + per_x * tile.left + per_y * tile.top;
      const std::int64_t smallest = at + (std::min<std::int64_t>(0, per_x) + std::min<std::int64_t>(0, per_y)) * kSpan;
      const std::int64_t largest = at + (std::max<std::int64_t>(0, per_x) + std::max<std::int64_t>(0, per_y)) * kSpan;
      is_in_tile &= largest >= 0;
      inside[i] = smallest >= 0;
      // Of near triangles every value in the tile fits; of far ones those of edges that cross it.
      at_tile[i] = static_cast<std::int32_t>(at);
      if (i == 0) continue;
      const bool top_left = per_x > 0 || (per_x == 0 && per_y > 0);
      const auto rest = static_cast<float>((moved & 255) + (top_left ? 0 : 1));
      offset[i - 1] = rest * (t.weight_scale * 0x1p-8f);
    }
  }
};

/// One triangle in one multisampled tile, a block at a time.
template <class F>
class SampledTriangle {
 public:
  HWY_INLINE SampledTriangle(const ScreenTriangle& triangle, const Tile& tile) : triangle_(triangle), samples_(tile.samples) {
    const auto positions = sample_positions(samples_);
    for (int s = 0; s < samples_; ++s) edges_[s].begin(triangle, tile, positions[static_cast<std::size_t>(s)]);
    centre_.begin(triangle, tile, {0, 0});
    // At the centres the record's own offsets hold, which were rounded from other doubles.
    for (int i = 0; i < 2; ++i) centre_.offset[i] = triangle.weight_offset[i];
    if (!triangle.is_near) planes_.begin(triangle, tile);
    for (int i = 0; i < 3; ++i) edge_lanes_[i] = lane_x() * Int(triangle.per_x[i]) + lane_y() * Int(triangle.per_y[i]);
  }

  /// Coverage, weights and depths of the block whose first pixel is (x, y) of the tile; `within` are
  /// the pixels that may be drawn. False when no sample is covered.
  HWY_INLINE bool cover(int x, int y, std::uint64_t within, FragmentBlock& block) const {
    block.live = 0;
    for (int s = 0; s < samples_; ++s) {
      block.sample_live[s] = is_outside(edges_[s], x, y) ? 0 : cover_sample(edges_[s], x, y, within, block.depth_value[s]);
      block.live |= block.sample_live[s];
    }
    if (block.live == 0) return false;
    for (int first = 0; first < kBlockPixels; first += kLanes) {
      if ((block.live >> first & kGroupBits) == 0) continue;
      F weight[2];
      weights(centre_, x + block_x(first), y + block_y(first), weight);
      store(weight[0], block.weight[0] + first);
      store(weight[1], block.weight[1] + first);
    }
    return true;
  }

 private:
  static constexpr std::uint64_t kGroupBits = (std::uint64_t{1} << kLanes) - 1;

  HWY_INLINE std::uint64_t cover_sample(const SampleEdges& edges, int x, int y, std::uint64_t within, float* depth) const {
    std::uint64_t covered = 0;
    for (int first = 0; first < kBlockPixels; first += kLanes) {
      const int group_x = x + block_x(first), group_y = y + block_y(first);
      const Int outside = edge(edges, 0, group_x, group_y) | edge(edges, 1, group_x, group_y) | edge(edges, 2, group_x, group_y);
      const std::uint64_t bits = bits_of(!is_negative(outside)) & (within >> first & kGroupBits);
      if (bits == 0) continue;
      covered |= bits << first;
      F weight[2];
      weights(edges, group_x, group_y, weight);
      store(interpolated_depth(triangle_, weight), depth + first);
    }
    return covered;
  }

  HWY_INLINE Int edge(const SampleEdges& edges, int i, int x, int y) const {
    if (!triangle_.is_near && edges.inside[i]) return Int(0);
    return Int(edges.at_tile[i] + triangle_.per_x[i] * x + triangle_.per_y[i] * y) + edge_lanes_[i];
  }

  HWY_INLINE void weights(const SampleEdges& edges, int x, int y, F* weight) const {
    if (!triangle_.is_near)
      return planes_.weights(planes_.columns<F>(x) + edges.right, planes_.rows<F>(y) + edges.down, weight);
    for (int i = 0; i < 2; ++i)
      weight[i] = mul_add(to_float<F>(edge(edges, i + 1, x, y)), F(triangle_.weight_scale), F(edges.offset[i]));
  }

  HWY_INLINE bool is_outside(const SampleEdges& edges, int x, int y) const {
    constexpr int kSpan = kBlockSize - 1;
    if (!edges.is_in_tile) return true;
    for (int i = 0; i < 3; ++i) {
      const std::int32_t per_x = triangle_.per_x[i], per_y = triangle_.per_y[i];
      if (edges.inside[i]) continue;
      const std::int32_t at_block = edges.at_tile[i] + per_x * x + per_y * y;
      if (at_block + kSpan * (std::max(0, per_x) + std::max(0, per_y)) < 0) return true;
    }
    return false;
  }

  const ScreenTriangle& triangle_;
  int samples_;
  SampleEdges centre_, edges_[kMaxSamples];
  WeightPlanes planes_;
  Int edge_lanes_[3];
};

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
