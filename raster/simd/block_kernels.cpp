#include "raster/fragment_block.hpp"

#include <algorithm>

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "raster/simd/block_kernels.cpp"
#include "raster/simd/every_instruction_set.hpp"

#include "raster/simd/blend-inl.hpp"
#include "raster/simd/depth-inl.hpp"
#include "raster/simd/interpolation-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Writes each group of fragments to the block that it belongs to. Small triangles are walked across
/// the borders of blocks, so a block may be met again; there are never many to look through.
template <class F>
struct BlockWriter {
  const ScreenTriangle& triangle;
  const Tile& tile;
  std::vector<FragmentBlock>& out;
  const std::size_t first_block;  // of this triangle in this tile

  HWY_INLINE void operator()(const FragmentGroup<F>& group) {
    const int block = group.index / kBlockPixels, first = group.index % kBlockPixels;
    FragmentBlock& to = block_at(tile.left + block % kBlocksPerTileRow * kBlockSize,
                                 tile.top + block / kBlocksPerTileRow * kBlockSize);
    to.live |= static_cast<std::uint64_t>(bits_of(group.covered)) << first;
    to.sample_live[0] = to.live;
    store(interpolated_depth(triangle, group.weight), to.depth_value[0] + first);
    store(group.weight[0], to.weight[0] + first);
    store(group.weight[1], to.weight[1] + first);
  }

  FragmentBlock& block_at(int left, int top) {
    for (std::size_t i = out.size(); i > first_block; --i)
      if (out[i - 1].left == left && out[i - 1].top == top) return out[i - 1];
    FragmentBlock& added = out.emplace_back();
    added.left = left;
    added.top = top;
    added.triangle = &triangle;
    return added;
  }
};

template <Precision P>
void rasterize(const ScreenTriangle& triangle, const Tile& tile, const PixelRect& clip, std::vector<FragmentBlock>& out) {
  TriangleWalk<Float<P>> walk;
  if (!walk.begin(triangle, tile, clip)) return;
  const std::size_t first_block = out.size();
  BlockWriter<Float<P>> writer{triangle, tile, out, first_block};
  walk.for_each_group(writer);
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(first_block), out.end(), [](const FragmentBlock& a, const FragmentBlock& b) {
    return a.top != b.top ? a.top < b.top : a.left < b.left;
  });
}

HWY_INLINE Mask live_lanes(const FragmentBlock& block, int first) {
  return mask_of(static_cast<std::uint32_t>(block.live >> first & ((1u << kLanes) - 1u)));
}

HWY_INLINE int index_of(const FragmentBlock& block, const Tile& tile) {
  return index_in_tile(block.left - tile.left, block.top - tile.top);
}

template <Precision P>
void apply_fog(FragmentBlock&, const ChunkView&, const OutputState&) {}

template <Precision P>
void test_alpha(FragmentBlock&, const OutputState&) {}

template <Precision P>
void test_depth(FragmentBlock& block, const OutputState& state, const Tile& tile) {
  using F = Float<P>;
  std::uint64_t passed = 0;
  for (int first = 0; first < kBlockPixels; first += kLanes) {
    const Mask live = live_lanes(block, first);
    if (none(live)) continue;
    const Int code = depth_code(load<F>(block.depth_value[0] + first), state);
    store(code, block.depth[0] + first);
    const Mask passing = depth_test(live, code, state, tile.depth + index_of(block, tile) + first);
    passed |= static_cast<std::uint64_t>(bits_of(passing)) << first;
  }
  block.live = block.sample_live[0] = passed;
}

template <Precision P>
void blend_block(const FragmentBlock& block, const OutputState& state, const Tile& tile) {
  using F = Float<P>;
  if (!state.blend.write) return;
  for (int first = 0; first < kBlockPixels; first += kLanes) {
    const Mask live = live_lanes(block, first);
    if (none(live)) continue;
    const Vec4<F> colour{load<F>(block.colour[0] + first), load<F>(block.colour[1] + first),
                         load<F>(block.colour[2] + first), load<F>(block.colour[3] + first)};
    write_colour(live, colour, state, tile.colour, index_of(block, tile) + first);
  }
}

const BlockKernels& block_table(Precision precision) {
  static constexpr BlockKernels kExact{&rasterize<Precision::exact>, &apply_fog<Precision::exact>, &test_alpha<Precision::exact>, &test_depth<Precision::exact>,
                                       &blend_block<Precision::exact>};
  static constexpr BlockKernels kFast{&rasterize<Precision::fast>, &apply_fog<Precision::fast>, &test_alpha<Precision::fast>, &test_depth<Precision::fast>,
                                      &blend_block<Precision::fast>};
  return precision == Precision::exact ? kExact : kFast;
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tuberia {

const BlockKernels& block_kernels(InstructionSet instruction_set, Precision precision) noexcept {
  TUBERIA_RETURN_FOR(instruction_set, block_table(precision))
}

}  // namespace tuberia
#endif
