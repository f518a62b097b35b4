// Stages 7 to 9 of the pipeline on one register of fragments: the order in which a fragment becomes
// a pixel. The stages' own work is in raster/simd; here it is fused around one program, so that
// nothing between coverage and the stored pixel leaves the registers.

#if defined(TUBERIA_PIPELINE_FRAGMENT_CHAIN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_FRAGMENT_CHAIN_INL
#undef TUBERIA_PIPELINE_FRAGMENT_CHAIN_INL
#else
#define TUBERIA_PIPELINE_FRAGMENT_CHAIN_INL
#endif

#include <algorithm>
#include <bit>

#include "pipeline/colour_blocks-inl.hpp"
#include "pipeline/fragment-inl.hpp"
#include "pipeline/fragment_program.hpp"
#include "raster/simd/blend-inl.hpp"
#include "raster/simd/hidden_surfaces-inl.hpp"
#include "raster/simd/interpolation-inl.hpp"
#include "raster/simd/perspective_segments-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

template <class Program, class F>
class FragmentChain {
 public:
  HWY_INLINE FragmentChain(const FragmentJob& job, const Tile& tile, TileVisibility& visibility, const ChunkView& chunk)
      : job_(job), output_(job.output), tile_(tile), chunk_(chunk), hidden_(job.output, job.order, tile, visibility),
        uniforms_(*static_cast<const typename Program::Uniforms*>(job.uniforms)), passes_all_(hidden_.tests_nothing()) {}

  HWY_INLINE void begin(const ScreenTriangle& triangle) {
    triangle_ = &triangle;
    if (!shades()) return;
    attributes_.load(triangle, chunk_, job_.flat_shading);
    if constexpr (kOneColour) begin_one_colour();
    if constexpr (Program::passes_colour_on) begin_blocks(triangle);
  }

  /// The same of a register of triangles, a bit each, as far as that is known without a closer look.
  HWY_INLINE std::uint32_t surely_hidden(const std::int32_t* numbers) const { return hidden_.surely_hidden(chunk_.extents, numbers); }

  /// Whether all of a small triangle is hidden.
  HWY_INLINE bool hides(const TriangleExtent& extent) { return hidden_.is_of_use() && hidden_.hides(extent); }

  /// Whether all of a large one is hidden. Otherwise decides whether its blocks are worth asking.
  HWY_INLINE bool hides_large(const TriangleWalk<F>& walk) {
    asks_blocks_ = hidden_.is_of_use();
    if (!asks_blocks_ || !walk.has_much_of_tile()) return false;
    float lowest, highest;
    walk.depth_bounds(0, 0, kTileSize - 1, lowest, highest);
    const auto outlook = hidden_.outlook(lowest, highest);
    asks_blocks_ = outlook == HiddenSurfaces<F>::Outlook::mixed;
    passes_all_ |= outlook == HiddenSurfaces<F>::Outlook::clear;
    return outlook == HiddenSurfaces<F>::Outlook::hidden;
  }

  /// Whether a block of the tile hides the triangle there.
  HWY_INLINE bool hides(const TriangleWalk<F>& walk, int x, int y) {
    if (!asks_blocks_) return false;
    float lowest, highest;
    walk.depth_bounds(x, y, kBlockSize - 1, lowest, highest);
    return hidden_.hides(y / kBlockSize * kBlocksPerTileRow + x / kBlockSize, lowest, highest);
  }

  /// Covers what is in this tile of a triangle that is not known to be hidden.
  HWY_INLINE void add(const ScreenTriangle& triangle, TriangleWalk<F>& walk) {
    if (!walk.begin(triangle)) return;
    if (walk.is_small()) return walk.cover_small(groups_, *this);
    if (!walk.place(tile_)) return;
    flush();  // what is pending comes first, and may not pass all
    if (hides_large(walk)) return;
    begin(triangle);
    walk.cover_blocks(groups_, *this);
    flush();
    passes_all_ = hidden_.tests_nothing();
  }

  /// Asks memory for the depths, and the codes of 8 bits a channel, of a group that may be drawn soon.
  HWY_INLINE void prepare(int index) const {
    prefetch(reinterpret_cast<const char*>(tile_.depth + index));
    prefetch(reinterpret_cast<const char*>(pixels(index)));
  }

  /// Draws what has been covered.
  HWY_NOINLINE void flush() {
    for (int i = 0; i < groups_.count(); ++i) {
      if (&groups_.triangle(i) != triangle_) begin(groups_.triangle(i));
      (*this)(groups_.group(i));
    }
    groups_.clear();
  }

  /// Draws a block whose pixels are all covered, if all pass and there is a short way.
  HWY_INLINE bool takes_block(const TriangleWalk<F>& walk, int x, int y) {
    if (!passes_all_ || !shades()) return false;
    if constexpr (kOneColour) {
      if (!one_colour_.is_ready()) return false;
      one_colour_.write_block(output_.colour_format, pixels(index_in_tile(x, y)));
      return true;
    } else if constexpr (Program::passes_colour_on) {
      if (!lays_blocks_ || !walk.is_near()) return false;
      colour_blocks_.lay_over(walk, x, y, pixels(index_in_tile(x, y)));
      return true;
    } else {
      return false;
    }
  }

  /// One register of covered fragments through the rest of the pipeline.
  HWY_INLINE void operator()(const FragmentGroup<F>& group) {
    Mask live = group.covered;

    // 8 early: unless the program may discard, a fragment that will be hidden need not be shaded.
    if constexpr (!Program::may_discard) {
      if (!passes_all_) live = hidden_.test(live, interpolated_depth(*triangle_, group.weight), group.index);
      if (none(live) || !shades()) return;
    }

    // 7 FragmentShading.
    if constexpr (kOneColour) {
      if (one_colour_.is_ready()) return one_colour_.write(live, output_.colour_format, pixels(group.index));
    }
    const Vec4<F> colour = shade(group, live);

    // 8 DepthTest, late.
    if constexpr (Program::may_discard) {
      if (none(live)) return;
      live = hidden_.test(live, interpolated_depth(*triangle_, group.weight), group.index);
      if (none(live) || !output_.blend.write) return;
    }

    // 9 Blending.
    write_colour(live, colour, output_, tile_.colour, group.index);
  }

  /// Runs the program; `live` loses the fragments it discards.
  HWY_INLINE Vec4<F> shade(const FragmentGroup<F>& group, Mask& live) {
    Fragment<Program, F> fragment(attributes_, live, level_guess_);
    if constexpr (Program::interpolated != Attributes::none) {
      F corrected[2];
      correct(group, corrected);
      fragment.set_weights(corrected[0], corrected[1]);
    }
    const Vec4<F> colour = Program::shade(fragment, uniforms_);
    if constexpr (Program::may_discard) live = fragment.live();
    return colour;
  }

 private:
  // Nothing varies over the triangle, so neither does its colour.
  static constexpr bool kOneColour = Program::interpolated == Attributes::none && !Program::may_discard;

  HWY_INLINE void correct(const FragmentGroup<F>& group, F* corrected) {
    if (triangle_->perspective <= kIsAffine) [[likely]] return correct_perspective(*triangle_, group.weight, corrected);
    // Copies, so that the others' weights stay in registers.
    const F linear[2] = {group.weight[0], group.weight[1]};
    F found[2];
    segments_.correct(*triangle_, tile_.left + column_in_tile(group.index), tile_.top + row_in_tile(group.index), linear, found);
    corrected[0] = found[0], corrected[1] = found[1];
  }

  HWY_INLINE bool shades() const { return Program::may_discard || output_.blend.write; }

  HWY_INLINE void begin_blocks(const ScreenTriangle& triangle) {
    lays_blocks_ = passes_all_ && triangle.perspective <= kIsAffine && output_.blend.mode == BlendMode::source_over && output_.colour_format == ColourFormat::rgba8;
    if (lays_blocks_) colour_blocks_.begin(triangle, attributes_.value, attributes_.delta1, attributes_.delta2);
  }
  HWY_INLINE void begin_one_colour() {
    Mask live = all_lanes();
    one_colour_.begin(shade(FragmentGroup<F>{0, live, {F(0.0f), F(0.0f)}}, live), output_);
  }
  HWY_INLINE std::uint32_t* pixels(int index) const { return static_cast<std::uint32_t*>(tile_.colour) + index; }

  const FragmentJob& job_;
  const OutputState& output_;
  const Tile& tile_;
  const ChunkView& chunk_;
  HiddenSurfaces<F> hidden_;
  const typename Program::Uniforms& uniforms_;
  const ScreenTriangle* triangle_ = nullptr;
  TriangleAttributes<Program> attributes_;
  LevelGuess level_guess_;
  bool asks_blocks_ = false, passes_all_ = false, lays_blocks_ = false;
  OneColour<F> one_colour_;        // of programs where nothing varies
  ColourBlocks<F> colour_blocks_;  // of programs that pass the vertices' colours on
  CoveredGroups<F> groups_;
  PerspectiveSegments<F> segments_;
};

/// A few triangles of a tile's list that are not hidden, on their way through memory: first their
/// records are asked for, then their vertices' attributes, then they are drawn.
template <class Program, class F>
class VisibleTriangles {
 public:
  static constexpr std::size_t kMost = 16;

  HWY_INLINE void add(const ScreenTriangle& triangle) {
    prefetch(reinterpret_cast<const char*>(&triangle));
    prefetch(reinterpret_cast<const char*>(&triangle) + 64);
    triangles_[count_++] = &triangle;
  }

  std::int64_t count() const { return static_cast<std::int64_t>(count_); }

  HWY_INLINE void draw(FragmentChain<Program, F>& chain, TriangleWalk<F>& walk, const ChunkView& chunk) {
    if constexpr (TriangleAttributes<Program>::kCount > 0)
      for (std::size_t i = 0; i < count_; ++i)
        for (const std::uint16_t slot : triangles_[i]->vertex) prefetch(reinterpret_cast<const char*>(chunk.attributes + slot * chunk.stride));
    for (std::size_t i = 0; i < count_; ++i) chain.add(*triangles_[i], walk);
    chain.flush();
    count_ = 0;
  }

 private:
  const ScreenTriangle* triangles_[kMost];
  std::size_t count_ = 0;
};

template <class Program, Precision P>
void draw_tile(const FragmentJob& job, const Tile& tile, TileVisibility& visibility, const ChunkView& chunk,
               std::span<const std::uint16_t> listed) {
  using F = Float<P>;
  FragmentChain<Program, F> chain(job, tile, visibility, chunk);
  TriangleWalk<F> walk(tile, job.output.clip);
  VisibleTriangles<Program, F> visible;
  const auto count = static_cast<std::int64_t>(listed.size());
  const auto number = [&](std::int64_t i) HWY_ATTR { return listed[static_cast<std::size_t>(in_draw_order(i, count, job.order))]; };
  constexpr std::int64_t kWindow = VisibleTriangles<Program, F>::kMost, kAhead = kWindow + 8;
  static_assert(kWindow % kLanes == 0);
  bool hides_many = false;  // of the last window: then a register is asked about at once, first
  for (std::int64_t first = 0; first < count; first += kWindow) {
    const std::int64_t in_window = std::min(kWindow, count - first);
    std::int32_t numbers[kWindow];
    std::fill_n(numbers, kWindow, number(first));  // lanes without a triangle ask what is in this tile, too
    for (std::int64_t i = 0; i < in_window; ++i) {
      numbers[i] = number(first + i);
      if (first + i + kAhead < count) prefetch(reinterpret_cast<const char*>(&chunk.extents[number(first + i + kAhead)]));
    }
    for (std::int64_t i = 0; i < in_window; i += kLanes) {
      std::uint32_t in_sight = (1u << std::min<std::int64_t>(kLanes, in_window - i)) - 1u;
      if (hides_many) in_sight &= ~chain.surely_hidden(numbers + i);
      for (; in_sight != 0; in_sight &= in_sight - 1) {
        const std::int32_t candidate = numbers[i + std::countr_zero(in_sight)];
        if (!chain.hides(chunk.extents[candidate])) visible.add(chunk.triangles[candidate]);
      }
    }
    hides_many = 2 * visible.count() < in_window;
    visible.draw(chain, walk, chunk);
  }
}

template <class Program, Precision P>
void shade_block(const FragmentJob& job, const ChunkView& chunk, FragmentBlock& block) {
  using F = Float<P>;
  const Tile place{.left = block.left, .top = block.top};  // of the block's pixels, as if it were a tile's first block
  TileVisibility nothing_known;
  FragmentJob shading = job;
  shading.output.blend.write = true;
  FragmentChain<Program, F> chain(shading, place, nothing_known, chunk);
  chain.begin(*block.triangle);
  std::uint64_t kept = 0;
  for (int first = 0; first < kBlockPixels; first += kLanes) {
    Mask live = mask_of(static_cast<std::uint32_t>(block.live >> first & ((1u << kLanes) - 1u)));
    if (none(live)) continue;
    const FragmentGroup<F> group{first, live, {load<F>(block.weight[0] + first), load<F>(block.weight[1] + first)}};
    const Vec4<F> colour = chain.shade(group, live);
    store(colour.x, block.colour[0] + first);
    store(colour.y, block.colour[1] + first);
    store(colour.z, block.colour[2] + first);
    store(colour.w, block.colour[3] + first);
    kept |= static_cast<std::uint64_t>(bits_of(live)) << first;
  }
  block.live = kept;
  for (int s = 0; s < block.samples; ++s) block.sample_live[s] &= kept;
}

template <class Program, Precision P>
inline constexpr ProgramKernels kKernels{&draw_tile<Program, P>, &shade_block<Program, P>};

/// The kernels of a program for the instruction set that is being compiled. Validation lets only those
/// precisions come here that the program has.
template <class Program>
const ProgramKernels& kernels_of(Precision precision) {
  if constexpr (Program::has_ingredients) {
    if (precision == Precision::fast_reciprocal) return kKernels<Program, Precision::fast_reciprocal>;
    if (precision == Precision::fast_inverse_sqrt) return kKernels<Program, Precision::fast_inverse_sqrt>;
    if (precision == Precision::fused_multiply_add) return kKernels<Program, Precision::fused_multiply_add>;
    if (precision == Precision::fast_power) return kKernels<Program, Precision::fast_power>;
  }
  return precision == Precision::fast ? kKernels<Program, Precision::fast> : kKernels<Program, Precision::exact>;
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
