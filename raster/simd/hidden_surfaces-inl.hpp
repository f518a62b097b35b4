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
    if (output_.depth.write && compares_by_size_) doubt(index);
    return passed;
  }

  /// Whether no fragment of this block can pass whose depth lies between these.
  HWY_INLINE bool hides(int block, float lowest, float highest) { return hides(block, nearest_key(lowest, highest)); }

  /// What a triangle that has much of the tile can expect: that all its blocks hide it, some, or none;
  /// clear: that moreover every fragment passes and leaves the depths as they are.
  enum class Outlook { hidden, mixed, open, clear };
  HWY_INLINE Outlook outlook(float lowest, float highest) {
    if (!compares_by_size_) return first_wins_ ? Outlook::mixed : Outlook::open;
    if (!visibility_.is_summarized) summarize();
    if (nearest_key(lowest, highest) > visibility_.farthest_of_all) return Outlook::hidden;
    const std::int32_t last = last_key(lowest, highest);
    if (!output_.depth.write && !is_reversed_ && last <= visibility_.nearest_pixel) return Outlook::clear;
    const bool some_hide = last > visibility_.nearest_of_all;
    return some_hide || first_wins_ ? Outlook::mixed : Outlook::open;
  }

  /// Whether all of a small triangle is hidden in this tile. (Of a large one that is not known.)
  HWY_INLINE bool hides(const TriangleExtent& t) {
    if (t.lowest == -std::numeric_limits<float>::infinity()) return false;
    const int left = std::max(t.left - tile_.left, 0) / kBlockSize, right = std::min(t.right - tile_.left, kTileSize - 1) / kBlockSize;
    const int top = std::max(t.top - tile_.top, 0) / kBlockSize, bottom = std::min(t.bottom - tile_.top, kTileSize - 1) / kBlockSize;
    const std::int32_t key = nearest_key(t.lowest, t.highest);
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x)
        if (!hides(y * kBlocksPerTileRow + x, key)) return false;
    return true;
  }

  /// Of a register of triangles a bit each: whether what is known already tells that `hides` is true.
  /// numbers: those of the triangles' extents. One that spans three blocks or is large is not asked.
  HWY_INLINE std::uint32_t surely_hidden(const TriangleExtent* extents, const std::int32_t* numbers) const {
    if (!compares_by_size_) return 0;
    const auto* words = reinterpret_cast<const std::int32_t*>(extents);
    const Int first = shift_left<2>(load(numbers));
    const Int left_top = gather(words, first), right_bottom = gather(words + 1, first);
    const F lowest = float_of_bits<F>(gather(words + 2, first)), highest = float_of_bits<F>(gather(words + 3, first));

    constexpr int kBlockBits = 3;
    static_assert(1 << kBlockBits == kBlockSize);
    const Int tile_left(tile_.left), tile_top(tile_.top), last(kTileSize - 1);
    const Int left = shift_right<kBlockBits>(max(arithmetic_shift_right<16>(shift_left<16>(left_top)) - tile_left, Int(0)));
    const Int top = shift_right<kBlockBits>(max(arithmetic_shift_right<16>(left_top) - tile_top, Int(0)));
    const Int right = shift_right<kBlockBits>(min(arithmetic_shift_right<16>(shift_left<16>(right_bottom)) - tile_left, last));
    const Int bottom = shift_right<kBlockBits>(min(arithmetic_shift_right<16>(right_bottom) - tile_top, last));
    const Mask asked = (right - left < Int(2)) & (bottom - top < Int(2)) & (lowest <= highest) & (lowest > -std::numeric_limits<float>::infinity());

    // At most 2x2 blocks: those of the corners.
    const Int upper = top * Int(kBlocksPerTileRow), lower = bottom * Int(kBlocksPerTileRow);
    const auto farthest = [&](Int block) HWY_ATTR { return gather(visibility_.farthest, select(asked, block, Int(0))); };
    const Int limit = max(max(farthest(upper + left), farthest(upper + right)), max(farthest(lower + left), farthest(lower + right)));
    const Int code = depth_code(prefers_greater_ ? highest : lowest, output_);
    const Int key = (prefers_greater_ ? ~code : code) + Int(tie_hides_);
    return bits_of(asked & (key > limit));
  }

  /// Whether every fragment passes and leaves the depths as they are, wherever it lies.
  HWY_INLINE bool tests_nothing() const { return !is_reversed_ && output_.depth == kDepthOff; }
  /// Whether anything can be hidden at all.
  HWY_INLINE bool is_of_use() const { return compares_by_size_ || first_wins_; }

 private:
  HWY_INLINE bool hides(int block, std::int32_t nearest) {
    if (compares_by_size_) {
      if (nearest > visibility_.farthest[block]) return true;
      if (visibility_.doubts[block] != 0 && (visibility_.doubts[block] += 2) >= kEnoughDoubts) {
        if (may_have_come_nearer(block)) return nearest > find_farthest(block);
        visibility_.doubts[block] = 1;
      }
    }
    return first_wins_ && visibility_.written[block] == ~std::uint64_t{0};
  }

  /// As long as a draw, last first, has left out a pixel of the block, that one is most likely the farthest.
  HWY_INLINE bool may_have_come_nearer(int block) const {
    return !is_reversed_ || visibility_.written[block] == ~std::uint64_t{0} || visibility_.farthest[block] == TileVisibility::kNeverLookedAt;
  }

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
    if (!first_wins_) doubt(index);
    word |= static_cast<std::uint64_t>(bits_of(live)) << shift;
    return live;
  }

  HWY_INLINE void doubt(int index) {
    ++visibility_.doubts[index / kBlockPixels];  // may start again at 0: that only costs time
    visibility_.is_summarized = false;
  }

  HWY_INLINE std::int32_t find_farthest(int block) {
    const std::int32_t* depth = tile_.depth + block * kBlockPixels;
    const Int flip(prefers_greater_ ? -1 : 0);
    Int largest = load(depth) ^ flip;
    for (int i = kLanes; i < kBlockPixels; i += kLanes) largest = max(largest, load(depth + i) ^ flip);
    visibility_.farthest[block] = largest_lane(largest);
    visibility_.doubts[block] = 0;
    visibility_.is_summarized = false;
    return visibility_.farthest[block];
  }

  HWY_NOINLINE void summarize() {
    std::int32_t largest = std::numeric_limits<std::int32_t>::min(), smallest = std::numeric_limits<std::int32_t>::max();
    for (int block = 0; block < kBlocksPerTile; ++block) {
      const std::int32_t farthest = visibility_.doubts[block] != 0 ? find_farthest(block) : visibility_.farthest[block];
      largest = std::max(largest, farthest);
      smallest = std::min(smallest, farthest);
    }
    visibility_.farthest_of_all = largest;
    visibility_.nearest_of_all = smallest;
    if (!output_.depth.write && visibility_.nearest_pixel == TileVisibility::kNotLookedFor) find_nearest_pixel();
    visibility_.is_summarized = true;
  }

  HWY_INLINE void find_nearest_pixel() {
    const Int flip(prefers_greater_ ? -1 : 0);
    Int largest = ~(load(tile_.depth) ^ flip);
    for (int i = kLanes; i < kTilePixels; i += kLanes) largest = max(largest, ~(load(tile_.depth + i) ^ flip));
    visibility_.nearest_pixel = ~largest_lane(largest);
  }

  /// The smallest key of the codes of depths between these; one more where a tie hides. The least of
  /// all when they are not numbers, or do not matter.
  HWY_INLINE std::int32_t nearest_key(float lowest, float highest) const {
    if (!compares_by_size_ || !(lowest <= highest)) return std::numeric_limits<std::int32_t>::min();
    return (prefers_greater_ ? ~code_of(highest) : code_of(lowest)) + tie_hides_;
  }

  /// The largest, likewise.
  HWY_INLINE std::int32_t last_key(float lowest, float highest) const {
    if (!(lowest <= highest)) return std::numeric_limits<std::int32_t>::max();
    return (prefers_greater_ ? ~code_of(lowest) : code_of(highest)) + tie_hides_;
  }

  /// As depth_code, of one depth.
  HWY_INLINE std::int32_t code_of(float depth) const {
    const float clamped = std::min(std::max(depth, output_.min_depth), output_.max_depth);
    if (output_.depth_format == DepthFormat::d32f) return std::bit_cast<std::int32_t>(clamped + 0.0f);
    return static_cast<std::int32_t>(static_cast<double>(clamped) * scale_ + 0.5);
  }

  // A look at a block costs about as much as a register of shaded fragments.
  static constexpr std::uint8_t kEnoughDoubts = 4;
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
