// Blocks of pixels that lie all in one triangle whose interpolated colours are laid over rgba8 pixels,
// each seen: what the fragment chain does with them, in one short loop.

#if defined(TUBERIA_PIPELINE_COLOUR_BLOCKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_COLOUR_BLOCKS_INL
#undef TUBERIA_PIPELINE_COLOUR_BLOCKS_INL
#else
#define TUBERIA_PIPELINE_COLOUR_BLOCKS_INL
#endif

#include <algorithm>

#include "raster/simd/blend-inl.hpp"
#include "raster/simd/interpolation-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

template <class F>
class ColourBlocks {
 public:
  /// The colours: those of vertex 0 and what vertices 1 and 2 have more.
  HWY_INLINE void begin(const ScreenTriangle& triangle, const float* value, const float* delta1, const float* delta2) {
    triangle_ = &triangle;
    std::copy_n(value, 4, value_);
    std::copy_n(delta1, 4, delta1_);
    std::copy_n(delta2, 4, delta2_);
    is_plain_ = delta1[3] == 0 && delta2[3] == 0 && stays_in_unit();
  }

  /// Lays the triangle over the block at (x, y) of the tile; it must be near.
  HWY_INLINE void lay_over(const TriangleWalk<F>& walk, int x, int y, std::uint32_t* block) const {
    if (is_plain_) lay<true>(walk, x, y, block);
    else lay<false>(walk, x, y, block);
  }

 private:
  /// Whether no fragment's colour leaves [0, 1], so that clamping would not change it. Weights are right to
  /// some 2^-22, also corrected ones as long as the perspective is not extreme; channels that vary
  /// keep a distance from the ends that is many times what that makes of them.
  HWY_INLINE bool stays_in_unit() const {
    constexpr float kMargin = 0x1p-14f, kLeastInverse = 0.125f;
    const float* inverse_w = triangle_->inverse_w;
    if (std::min(std::min(inverse_w[0], inverse_w[1]), inverse_w[2]) < kLeastInverse) return false;
    for (int i = 0; i < 4; ++i) {
      const bool varies = delta1_[i] != 0 || delta2_[i] != 0;
      const float margin = varies ? kMargin : 0;
      const auto is_inside = [margin](float c) { return c >= margin && c <= 1 - margin; };  // not-a-number is not
      if (!is_inside(value_[i]) || !is_inside(value_[i] + delta1_[i]) || !is_inside(value_[i] + delta2_[i])) return false;
    }
    return true;
  }

  HWY_INLINE F channel(int i, const F* weight) const {
    return mul_add(weight[1], F(delta2_[i]), mul_add(weight[0], F(delta1_[i]), F(value_[i])));
  }

  /// A function of its own, so that its loop has all registers. kPlain: alpha is the same everywhere and
  /// the colours stay in [0, 1]; that saves a quarter of the time.
  template <bool kPlain>
  HWY_NOINLINE void lay(const TriangleWalk<F>& walk, int x, int y, std::uint32_t* block) const {
    const F same_alpha(value_[3]);
    const auto edges = walk.edges_of_block(x, y);
    Int first[2] = {edges.first[0], edges.first[1]};
    for (int row = 0; row < kBlockSize; row += kGroupHeight) {
      Int edge[2] = {first[0], first[1]};
      for (int column = 0; column < kBlockSize; column += kGroupWidth) {
        const F linear[2] = {walk.near_weight(0, edge[0]), walk.near_weight(1, edge[1])};
        F weight[2];
        correct_perspective(*triangle_, linear, weight);
        const F alpha = kPlain ? same_alpha : channel(3, weight);
        const Vec4<F> colour(channel(0, weight), channel(1, weight), channel(2, weight), alpha);
        std::uint32_t* pixels = block + index_in_block(column, row);
        store(over(layer_of(kPlain ? colour : saturate(colour)), load(pixels), ColourFormat::rgba8), pixels);
        for (int i = 0; i < 2; ++i) edge[i] = edge[i] + edges.per_column[i];
      }
      for (int i = 0; i < 2; ++i) first[i] = first[i] + edges.per_row[i];
    }
  }

  const ScreenTriangle* triangle_ = nullptr;
  float value_[4], delta1_[4], delta2_[4];
  bool is_plain_ = false;
};

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
