// Hidden surfaces: the depth test of a group when the triangles of a draw come in either order, and
// whole blocks that it need not be done for.

#if defined(TUBERIA_RASTER_SIMD_HIDDEN_SURFACES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_HIDDEN_SURFACES_INL
#undef TUBERIA_RASTER_SIMD_HIDDEN_SURFACES_INL
#else
#define TUBERIA_RASTER_SIMD_HIDDEN_SURFACES_INL
#endif

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "raster/simd/depth-inl.hpp"
#include "raster/simd/rasterizer-inl.hpp"
#include "raster/tile_visibility.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// A key orders depths so that a larger one is farther from passing: the code itself for less and
/// less_equal, its complement for greater and greater_equal.
template <class F>
class HiddenSurfaces {
 public:
  HWY_INLINE HiddenSurfaces(const OutputState& output, DrawOrder order, const Tile& tile, TileVisibility& visibility)
      : output_(output), tile_(tile), visibility_(visibility), is_reversed_(order == DrawOrder::last_first) {
    const Compare test = output.depth.test;
    const bool is_strict = test == Compare::less || test == Compare::greater;
    prefers_greater_ = test == Compare::greater || test == Compare::greater_equal;
    compares_by_size_ = is_strict || test == Compare::less_equal || test == Compare::greater_equal;
    first_wins_ = is_reversed_ && !keeps_nearest(output.depth);
    ties_to_written_ = is_strict;
    tie_hides_ = is_strict && !is_reversed_ ? 1 : 0;
    scale_ = output.depth_format == DepthFormat::d16 ? 65535.0 : 16777215.0;
  }

  /// The live fragments that the pixel will keep; their depths are stored if the state says so.
  HWY_INLINE Mask test(Mask live, F depth, int index) {
    if (is_reversed_) return test_reversed(live, depth, index);
    if (output_.depth == kDepthOff) return live;
    const Mask passed = depth_test(live, depth_code(depth, output_), output_, tile_.depth + index);
    if (output_.depth.write) forget_farthest(index);
    return passed;
  }

  /// Whether no fragment of this block can pass whose depth lies between these.
  HWY_INLINE bool hides(int block, float lowest, float highest) {
    if (first_wins_ && visibility_.written[block] == ~std::uint64_t{0}) return true;
    return compares_by_size_ && key_of(lowest, highest) + tie_hides_ > farthest(block);
  }

  /// What a triangle that has much of the tile can expect: that all its blocks hide it, some, or none.
  enum class Outlook { hidden, mixed, open };
  HWY_INLINE Outlook outlook(float lowest, float highest) {
    if (!compares_by_size_) return first_wins_ ? Outlook::mixed : Outlook::open;
    if (!visibility_.is_summarized) summarize();
    if (key_of(lowest, highest) + tie_hides_ > visibility_.farthest_of_all) return Outlook::hidden;
    const bool some_hide = last_key_of(lowest, highest) + tie_hides_ > visibility_.nearest_of_all;
    return some_hide || first_wins_ ? Outlook::mixed : Outlook::open;
  }

  /// Whether all of a near triangle is hidden, by the depths of its vertices. Weights are right to
  /// some 2^-22 inside the triangle, so no depth there lies farther beyond the vertices' than the margin.
  HWY_INLINE bool hides_small(const ScreenTriangle& t, const PixelRect& part) {
    const float second = t.depth + t.depth_delta[0], third = t.depth + t.depth_delta[1];
    const float margin = 0x1p-19f * (std::abs(t.depth) + std::abs(t.depth_delta[0]) + std::abs(t.depth_delta[1]));
    const float lowest = std::min(std::min(second, third), t.depth) - margin;
    const float highest = std::max(std::max(second, third), t.depth) + margin;
    for (int y = part.top / kBlockSize; y <= part.bottom / kBlockSize; ++y)
      for (int x = part.left / kBlockSize; x <= part.right / kBlockSize; ++x)
        if (!hides(y * kBlocksPerTileRow + x, lowest, highest)) return false;
    return true;
  }

  /// Whether anything can be hidden at all.
  HWY_INLINE bool is_of_use() const { return compares_by_size_ || first_wins_; }

 private:
  // Triangles that come last first: what was written by this draw was submitted later. Of equal
  // depths the strict comparisons keep the one that was submitted first, so the newcomer wins over
  // it; the others keep what is there. Where depth does not decide, the first to come stays.
  HWY_INLINE Mask test_reversed(Mask live, F depth, int index) {
    std::uint64_t& word = visibility_.written[index / kBlockPixels];
    const int shift = index % kBlockPixels;
    const Mask written = mask_of(static_cast<std::uint32_t>(word >> shift) & kAllBits);
    std::int32_t* stored = tile_.depth + index;
    if (first_wins_) {
      live = live & !written;
      if (output_.depth != kDepthOff) live = depth_test(live, depth_code(depth, output_), output_, stored);
    } else {
      const Int code = depth_code(depth, output_), old = load(stored);
      const Mask nearer = prefers_greater_ ? old < code : code < old;
      const Mask wins_ties = ties_to_written_ ? written : !written;
      live = live & (nearer | ((code == old) & wins_ties));
      store_where(live, code, stored);
    }
    if (output_.depth.write) forget_farthest(index);
    word |= static_cast<std::uint64_t>(bits_of(live)) << shift;
    return live;
  }

  HWY_INLINE void forget_farthest(int index) {
    visibility_.farthest_known &= ~(std::uint64_t{1} << (index / kBlockPixels));
    visibility_.is_summarized = false;
  }

  HWY_INLINE std::int32_t farthest(int block) {
    if ((visibility_.farthest_known >> block & 1) == 0) find_farthest(block);
    return visibility_.farthest[block];
  }

  HWY_INLINE void find_farthest(int block) {
    const std::int32_t* depth = tile_.depth + block * kBlockPixels;
    const Int flip(prefers_greater_ ? -1 : 0);
    Int largest = load(depth) ^ flip;
    for (int i = kLanes; i < kBlockPixels; i += kLanes) largest = max(largest, load(depth + i) ^ flip);
    visibility_.farthest[block] = largest_lane(largest);
    visibility_.farthest_known |= std::uint64_t{1} << block;
    visibility_.is_summarized = false;
  }

  HWY_NOINLINE void summarize() {
    std::int32_t largest = farthest(0), smallest = largest;
    for (int block = 1; block < kBlocksPerTile; ++block) {
      largest = std::max(largest, farthest(block));
      smallest = std::min(smallest, farthest(block));
    }
    visibility_.farthest_of_all = largest;
    visibility_.nearest_of_all = smallest;
    visibility_.is_summarized = true;
  }

  /// The smallest key of the codes of depths between these; the least of all when they are not numbers.
  HWY_INLINE std::int32_t key_of(float lowest, float highest) const {
    if (!(lowest <= highest)) return std::numeric_limits<std::int32_t>::min();
    return prefers_greater_ ? ~code_of(highest) : code_of(lowest);
  }

  /// The largest; the greatest of all when they are not numbers.
  HWY_INLINE std::int32_t last_key_of(float lowest, float highest) const {
    if (!(lowest <= highest)) return std::numeric_limits<std::int32_t>::max() - 1;
    return prefers_greater_ ? ~code_of(lowest) : code_of(highest);
  }

  /// As depth_code, of one depth.
  HWY_INLINE std::int32_t code_of(float depth) const {
    const float clamped = std::min(std::max(depth, output_.min_depth), output_.max_depth);
    if (output_.depth_format == DepthFormat::d32f) return std::bit_cast<std::int32_t>(clamped + 0.0f);
    return static_cast<std::int32_t>(static_cast<double>(clamped) * scale_ + 0.5);
  }

  static constexpr std::uint32_t kAllBits = (1u << kLanes) - 1u;

  const OutputState& output_;
  const Tile& tile_;
  TileVisibility& visibility_;
  bool is_reversed_;
  bool prefers_greater_, compares_by_size_;  // what the depth test compares
  bool first_wins_;        // reversed, and depth does not decide
  bool ties_to_written_;   // reversed: a newcomer wins over what this draw wrote at the same depth
  std::int32_t tie_hides_; // 1: at the same depth a newcomer is hidden
  double scale_;
};

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
