// The order of things: stage 0 in Pipeline::draw, then batch by batch stages 1 to 5 (pipeline/geometry_stages.hpp) for its chunks, and
// when these are there, 6 to 9 (pipeline/fragment_stages.hpp) for its tiles, while the next batch's chunks may begin.

#include "pipeline/pipeline.hpp"

#include <algorithm>

#include "base/parallel_batches.hpp"
#include "pipeline/batch_plan.hpp"
#include "pipeline/draw_order.hpp"
#include "pipeline/fragment_stages.hpp"
#include "pipeline/geometry_stages.hpp"
#include "pipeline/observer.hpp"
#include "pipeline/validate.hpp"

namespace tuberia {
namespace {

// In a batch for each thread, besides one to go ahead with: what the tiles read of them, some 256 KiB each, is still in
// the core's second cache then. (4: fastest of 2, 4, 8, ..., 128 on one thread; on two, 2 to 8 are alike.)
constexpr int kChunksPerThread = 4;

struct TileRange {
  std::int64_t first = 0, end = 0;
};

/// From the first to the last tile that any of the chunks touches.
TileRange touched_tiles(std::span<Chunk* const> chunks) {
  TileRange range;
  for (const Chunk* chunk : chunks) {
    const std::int64_t first = chunk->tiles.first_tile(), end = chunk->tiles.end_tile();
    if (first == end) continue;
    range = range.first == range.end ? TileRange{first, end} : TileRange{std::min(range.first, first), std::max(range.end, end)};
  }
  return range;
}

/// One draw on its way: batches of chunks go through the geometry stages, then tile by tile through the fragment stages.
template <class Tap>
class DrawInBatches final : public BatchedWork {
 public:
  DrawInBatches(RenderTarget& target, const DrawCall& draw, const AcceptedDraw& accepted, const PipelineOptions& options, int threads,
                DrawMemory& memory, Tap& tap)
      : target_(target), memory_(memory), tap_(tap),
        geometry_stages_(draw, accepted, options.instruction_set, options.precision),
        program_(draw.program.interface().kernels(options.instruction_set, options.precision)),
        fused_(!Tap::kWatches && !draw.count_fragments && accepted.is_everyday),
        job_{accepted.output, draw.program.uniforms(), draw.state.rasterization.flat_shading,
             fused_ ? choose_draw_order(draw, accepted) : DrawOrder::as_submitted},
        fragment_stages_(job_, draw.program.interface(), options.instruction_set, options.precision),
        counters_(fused_ ? 0 : static_cast<std::size_t>(target.tile_count())),
        plan_{geometry_stages_.primitives(), geometry_stages_.primitives_per_chunk(), std::int64_t{kChunksPerThread} * threads} {
    memory_.visibility.begin_draw(target.tile_count());
    memory_.blocks.resize(std::max(memory_.blocks.size(), static_cast<std::size_t>(threads)));
    tap_.begin_draw(plan_, target.tile_count());
  }

  DrawStatistics run(Workers& workers) {
    const int most_chunks = static_cast<int>(plan_.most_chunks());
    while (static_cast<int>(memory_.chunks.size()) < slot_count(workers, most_chunks)) memory_.chunks.push_back(std::make_unique<Chunk>());
    parallel_batches(workers, plan_.batches(), most_chunks, *this);
    for (const FragmentCounters& tile : counters_) statistics_ += tile.statistics();
    return statistics_;
  }

 private:
  int pieces(std::int64_t turn) const noexcept override { return static_cast<int>(plan_.chunks(batch(turn))); }

  // Stages 1 to 5, chunk by chunk; each chunk has one owner.
  void produce(std::int64_t turn, int number, int slot) override {
    Chunk& chunk = *memory_.chunks[static_cast<std::size_t>(slot)];
    chunk.range = plan_.range(batch(turn), number);
    tap_.begin(chunk);
    geometry_stages_(chunk, target_, tap_);
  }

  // All chunks of the batch are there: now the tiles get them.
  std::int64_t gather(std::int64_t turn, std::span<const int> slots) override {
    batch_ = batch(turn);
    chunks_.clear();
    for (const int slot : slots) chunks_.push_back(memory_.chunks[static_cast<std::size_t>(slot)].get());
    for (Chunk* chunk : chunks_) {
      stipple_start_ = geometry_stages_.continue_stipple(*chunk, stipple_start_);
      statistics_ += chunk->statistics;
    }
    touched_ = touched_tiles(chunks_);
    return touched_.end - touched_.first;
  }

  // Stages 6 to 9, tile by tile; each tile has one owner, who walks the chunks in order: that of
  // submission, or where it makes no difference the other way round. Everyday draws have the
  // fragment stages fused around the program, others run them one by one.
  void consume(std::int64_t place, int worker) override {
    const std::int64_t number = touched_.first + place;
    tap_.begin_tile(batch_, number);
    const Tile tile = target_.tile(static_cast<int>(number));
    std::vector<FragmentBlock>& blocks = memory_.blocks[static_cast<std::size_t>(worker)];
    const auto chunk_count = static_cast<std::int64_t>(chunks_.size());
    for (std::int64_t i = 0; i < chunk_count; ++i) {
      const Chunk& chunk = *chunks_[static_cast<std::size_t>(in_draw_order(i, chunk_count, job_.order))];
      const auto listed = chunk.tiles.of_tile(static_cast<int>(number));
      if (listed.empty()) continue;
      if (fused_) program_.draw_tile(job_, tile, memory_.visibility.of_tile(number), chunk.view(), listed);
      else fragment_stages_(chunk, listed, tile, blocks, counters_[static_cast<std::size_t>(number)], tap_);
    }
    tap_.end_tile(batch_, number);
  }

  /// The number of the batch whose turn it is.
  std::int64_t batch(std::int64_t turn) const noexcept { return in_draw_order(turn, plan_.batches(), job_.order); }

  RenderTarget& target_;
  DrawMemory& memory_;
  Tap& tap_;
  const GeometryStages geometry_stages_;
  const ProgramKernels& program_;
  const bool fused_;
  const FragmentJob job_;
  const FragmentStages fragment_stages_;
  std::vector<FragmentCounters> counters_;  // of the tiles
  const BatchPlan plan_;
  DrawStatistics statistics_;
  std::uint32_t stipple_start_ = 0;

  // Of the batch that the tiles have:
  std::int64_t batch_ = 0;
  std::vector<Chunk*> chunks_;
  TileRange touched_;
};

}  // namespace

Pipeline::Pipeline(const PipelineOptions& options) : options_(options), workers_(options.threads) {
  TUBERIA_ASSERT(is_supported(options.instruction_set), "this machine lacks the instruction set");
}

Result<DrawStatistics> Pipeline::draw(RenderTarget& target, const DrawCall& draw_call) {
  const Result<AcceptedDraw> accepted = validate(draw_call, target, workers_, options_.precision);     // stage 0
  if (!accepted) return accepted.error();
  return run(target, draw_call, *accepted, workers_, NoTap{});
}

Result<DrawStatistics> Pipeline::draw(RenderTarget& target, const DrawCall& draw_call, Observer& observer) {
  const Result<AcceptedDraw> accepted = validate(draw_call, target, workers_, options_.precision);
  if (!accepted) return accepted.error();
  observer.begin(draw_call, *accepted);
  Workers one(1);
  const DrawStatistics statistics = run(target, draw_call, *accepted, one, ObserverTap{observer});
  observer.end(statistics);
  return statistics;
}

Result<DrawStatistics> Pipeline::draw(RenderTarget& target, const DrawCall& draw_call, DrawTimes& times) {
  const auto begin = std::chrono::steady_clock::now();
  const Result<AcceptedDraw> accepted = validate(draw_call, target, workers_, options_.precision);
  times.validation += std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - begin).count();
  if (!accepted) return accepted.error();
  return run(target, draw_call, *accepted, workers_, ClockTap(times));
}

template <class Tap>
DrawStatistics Pipeline::run(RenderTarget& target, const DrawCall& draw_call, const AcceptedDraw& accepted, Workers& workers, Tap tap) {
  return DrawInBatches<Tap>(target, draw_call, accepted, options_, workers.thread_count(), memory_, tap).run(workers);
}

void Pipeline::clear(RenderTarget& target, const Rgba32F& colour, float depth) {
  target.clear_colour(colour, workers_);
  target.clear_depth(depth, workers_);
}

}  // namespace tuberia
