#include "raster/fragment_block.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "raster/simd/block_kernels.cpp"
#include "raster/simd/every_instruction_set.hpp"

#include "raster/simd/blend-inl.hpp"
#include "raster/simd/blend_function-inl.hpp"
#include "raster/simd/depth-inl.hpp"
#include "raster/simd/fog-inl.hpp"
#include "raster/simd/multisample-inl.hpp"
#include "raster/simd/perspective_segments-inl.hpp"
#include "raster/simd/stencil-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

HWY_INLINE Mask lanes_of(std::uint64_t bits, int first) {
  return mask_of(static_cast<std::uint32_t>(bits >> first & ((std::uint64_t{1} << kLanes) - 1)));
}
HWY_INLINE std::uint64_t bits_at(Mask lanes, int first) { return static_cast<std::uint64_t>(bits_of(lanes)) << first; }

HWY_INLINE int index_of(const FragmentBlock& block, const Tile& tile) {
  return index_in_tile(block.left - tile.left, block.top - tile.top);
}

HWY_INLINE FragmentBlock& added_block(std::vector<FragmentBlock>& out, const ScreenTriangle& triangle, int left, int top, int samples) {
  FragmentBlock& block = out.emplace_back();
  block.left = left;
  block.top = top;
  block.triangle = &triangle;
  block.samples = samples;
  return block;
}

/// Writes each group of fragments to the block that it belongs to. Groups come block by block.
template <class F>
struct BlockWriter {
  const ScreenTriangle& triangle;
  const Tile& tile;
  std::vector<FragmentBlock>& out;
  CoveredGroups<F> groups{};
  FragmentBlock* block = nullptr;
  int number = -1;  // of the block in the tile

  HWY_INLINE bool hides(const TriangleWalk<F>&, int, int) const { return false; }
  HWY_INLINE bool takes_block(const TriangleWalk<F>&, int, int) const { return false; }

  HWY_INLINE void flush() {
    for (int i = 0; i < groups.count(); ++i) write(groups.group(i));
    groups.clear();
  }

  HWY_INLINE void write(const FragmentGroup<F>& group) {
    const int first = group.index % kBlockPixels;
    if (group.index / kBlockPixels != number) begin(group.index / kBlockPixels);
    block->live |= bits_at(group.covered, first);
    block->sample_live[0] = block->live;
    store(interpolated_depth(triangle, group.weight), block->depth_value[0] + first);
    store(group.weight[0], block->weight[0] + first);
    store(group.weight[1], block->weight[1] + first);
  }

  void begin(int block_number) {
    number = block_number;
    block = &added_block(out, triangle, tile.left + number % kBlocksPerTileRow * kBlockSize,
                         tile.top + number / kBlocksPerTileRow * kBlockSize, 1);
  }
};

/// The pixels of a block that lie in a rectangle; both start from the block's first pixel.
inline std::uint64_t pixels_within(const PixelRect& rectangle) {
  const PixelRect part = intersection(rectangle, {0, 0, kBlockSize, kBlockSize});
  if (part == PixelRect{0, 0, kBlockSize, kBlockSize}) return ~std::uint64_t{0};
  std::uint64_t bits = 0;
  for (int y = part.top; y < part.bottom; ++y)
    for (int x = part.left; x < part.right; ++x) bits |= std::uint64_t{1} << index_in_block(x, y);
  return bits;
}

template <Precision P>
void rasterize_samples(const ScreenTriangle& triangle, const Tile& tile, const PixelRect& clip, std::vector<FragmentBlock>& out) {
  const PixelRect tile_pixels{tile.left, tile.top, tile.left + kTileSize, tile.top + kTileSize};
  const PixelRect bounds = intersection(intersection(clip, tile_pixels), {triangle.left, triangle.top, triangle.right + 1, triangle.bottom + 1});
  if (bounds.empty()) return;
  const SampledTriangle<Float<P>> sampled(triangle, tile);
  for (int y = (bounds.top - tile.top) & ~(kBlockSize - 1); y < bounds.bottom - tile.top; y += kBlockSize)
    for (int x = (bounds.left - tile.left) & ~(kBlockSize - 1); x < bounds.right - tile.left; x += kBlockSize) {
      const int left = tile.left + x, top = tile.top + y;
      const std::uint64_t within = pixels_within({bounds.left - left, bounds.top - top, bounds.right - left, bounds.bottom - top});
      if (!sampled.cover(x, y, within, added_block(out, triangle, left, top, tile.samples))) out.pop_back();
    }
}

template <Precision P>
void rasterize(const ScreenTriangle& triangle, const Tile& tile, const PixelRect& clip, std::vector<FragmentBlock>& out) {
  if (tile.samples > 1) return rasterize_samples<P>(triangle, tile, clip, out);
  TriangleWalk<Float<P>> walk(tile, clip);
  if (!walk.begin(triangle) || !walk.place(tile)) return;
  BlockWriter<Float<P>> writer{triangle, tile, out};
  walk.cover_blocks(writer.groups, writer);
  writer.flush();
}

template <Precision P>
void apply_fog(FragmentBlock& block, const ChunkView& chunk, const OutputState& state) {
  using F = Float<P>;
  if (state.fog.mode == FogMode::off || chunk.fog == nullptr) return;
  const ScreenTriangle& triangle = *block.triangle;
  const float c0 = chunk.fog[triangle.vertex[0]];
  const float c1 = chunk.fog[triangle.vertex[1]] - c0, c2 = chunk.fog[triangle.vertex[2]] - c0;
  const float fog_colour[3] = {state.fog.colour.r, state.fog.colour.g, state.fog.colour.b};
  PerspectiveSegments<F> segments;
  for (int first = 0; first < kBlockPixels; first += kLanes) {
    if (none(lanes_of(block.live, first))) continue;
    const F linear[2] = {load<F>(block.weight[0] + first), load<F>(block.weight[1] + first)};
    F weight[2];
    if (triangle.perspective > kIsAffine) segments.correct(triangle, block.left + block_x(first), block.top + block_y(first), linear, weight);
    else correct_perspective(triangle, linear, weight);
    const F interpolated = mul_add(weight[1], F(c2), mul_add(weight[0], F(c1), F(c0)));
    const F share = state.fog.per_vertex ? saturate(interpolated) : fog_share(abs(interpolated), state.fog);
    for (int c = 0; c < 3; ++c) store(fogged(load<F>(block.colour[c] + first), fog_colour[c], share), block.colour[c] + first);
  }
}

template <Precision P>
void test_alpha(FragmentBlock& block, const OutputState& state) {
  using F = Float<P>;
  const bool to_coverage = state.multisampling.alpha_to_coverage;
  if (!to_coverage && state.alpha_test.test == Compare::always) return;
  for (int first = 0; first < kBlockPixels; first += kLanes) {
    if (none(lanes_of(block.live, first))) continue;
    const F alpha = saturate(load<F>(block.colour[3] + first));
    const Mask passing = compare_alpha(alpha, state.alpha_test.reference, state.alpha_test.test);
    const Int kept = to_coverage ? samples_of_alpha(alpha, block.samples) : Int(block.samples);
    for (int s = 0; s < block.samples; ++s) block.sample_live[s] &= ~bits_at(!(passing & (kept > Int(s))), first);
  }
  block.live = 0;
  for (int s = 0; s < block.samples; ++s) block.live |= block.sample_live[s];
}

template <Precision P>
void test_depth(FragmentBlock& block, const OutputState& state, const Tile& tile) {
  using F = Float<P>;
  const StencilFace& face = block.triangle->is_back ? state.stencil.back : state.stencil.front;
  const int index = index_of(block, tile);
  block.live = 0;
  for (int s = 0; s < block.samples; ++s) {
    const Tile plane = plane_of_sample(tile, state.colour_format, s);
    std::uint64_t passed = 0;
    for (int first = 0; first < kBlockPixels; first += kLanes) {
      const Mask live = lanes_of(block.sample_live[s], first);
      if (none(live)) continue;
      const Int code = depth_code(load<F>(block.depth_value[s] + first), state);
      store(code, block.depth[s] + first);
      const int at = index + first;
      const Mask passing = state.stencil.enabled ? stencil_and_depth_test(live, code, face, state, plane.stencil + at, plane.depth + at)
                                                 : depth_test(live, code, state, plane.depth + at);
      passed |= bits_at(passing, first);
    }
    block.sample_live[s] = passed;
    block.live |= passed;
  }
}

/// Whether write_colour does it, as in the fused tile loops.
HWY_INLINE bool is_everyday_blend(const OutputState& state) {
  return state.blend.mode != BlendMode::function && state.blend.logic == LogicOperation::off && state.blend.mask.all() &&
         state.colour_format != ColourFormat::rgba16f;
}

template <Precision P>
void blend_block(const FragmentBlock& block, const OutputState& state, const Tile& tile) {
  using F = Float<P>;
  if (!state.blend.write) return;
  const bool everyday = is_everyday_blend(state);
  const int index = index_of(block, tile);
  for (int s = 0; s < block.samples; ++s) {
    const Tile plane = plane_of_sample(tile, state.colour_format, s);
    for (int first = 0; first < kBlockPixels; first += kLanes) {
      const Mask live = lanes_of(block.sample_live[s], first);
      if (none(live)) continue;
      const Vec4<F> colour{load<F>(block.colour[0] + first), load<F>(block.colour[1] + first),
                           load<F>(block.colour[2] + first), load<F>(block.colour[3] + first)};
      if (everyday) write_colour(live, colour, state, plane.colour, index + first);
      else write_any_colour(live, colour, state, plane.colour, index + first);
    }
  }
}

/// All but the fog are made of multiply-adds alone.
template <Precision P>
inline constexpr Precision kFusedOrNot = contains(P, Precision::fused_multiply_add) ? Precision::fast : Precision::exact;

template <Precision P>
inline constexpr BlockKernels kBlockTable{&rasterize<kFusedOrNot<P>>, &apply_fog<P>, &test_alpha<kFusedOrNot<P>>, &test_depth<kFusedOrNot<P>>,
                                          &blend_block<kFusedOrNot<P>>};

const BlockKernels& block_table(Precision precision) {
  switch (precision) {
    case Precision::exact:
    case Precision::fast_inverse_sqrt: break;
    case Precision::fast_reciprocal: return kBlockTable<Precision::fast_reciprocal>;
    case Precision::fused_multiply_add: return kBlockTable<Precision::fused_multiply_add>;
    case Precision::fast_power: return kBlockTable<Precision::fast_power>;
    case Precision::fast: return kBlockTable<Precision::fast>;
  }
  return kBlockTable<Precision::exact>;
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
