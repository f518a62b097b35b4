// The order of things: stage 0, then stages 1 to 5 in pipeline/geometry_stages.hpp, then 6 to 9 in
// pipeline/fragment_stages.hpp.

#include "pipeline/pipeline.hpp"

#include <algorithm>

#include "pipeline/draw_order.hpp"
#include "pipeline/fragment_stages.hpp"
#include "pipeline/geometry_stages.hpp"
#include "pipeline/observer.hpp"
#include "pipeline/validate.hpp"

namespace tuberia {
namespace {

// At once in flight for each thread: what the tiles read of them, some 256 KiB each, is still in
// the core's second cache then. (4: fastest of 2, 4, 8, ..., 128.)
constexpr std::int64_t kChunksPerThread = 4;

struct TileRange {
  std::int64_t first = 0, end = 0;
};

/// From the first to the last tile that any of the chunks touches.
TileRange touched_tiles(std::span<const std::unique_ptr<Chunk>> chunks) {
  TileRange range;
  for (const auto& chunk : chunks) {
    const std::int64_t first = chunk->tiles.first_tile(), end = chunk->tiles.end_tile();
    if (first == end) continue;
    range = range.first == range.end ? TileRange{first, end} : TileRange{std::min(range.first, first), std::max(range.end, end)};
  }
  return range;
}

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
DrawStatistics Pipeline::run(RenderTarget& target, const DrawCall& draw_call, const AcceptedDraw& accepted, Workers& workers, const Tap& tap) {
  const auto [isa, precision] = std::pair{options_.instruction_set, options_.precision};
  const GeometryStages geometry_stages(draw_call, accepted, isa, precision);
  const ProgramKernels& program = draw_call.program.interface().kernels(isa, precision);
  const bool fused = !Tap::kWatches && !draw_call.count_fragments && accepted.is_everyday;
  const FragmentJob job{accepted.output, draw_call.program.uniforms(), draw_call.state.rasterization.flat_shading,
                        fused ? choose_draw_order(draw_call, accepted) : DrawOrder::as_submitted};
  const FragmentStages fragment_stages(job, draw_call.program.interface(), isa, precision);
  std::vector<FragmentCounters> counters(fused ? 0 : static_cast<std::size_t>(target.tile_count()));

  visibility_.begin_draw(target.tile_count());
  blocks_.resize(static_cast<std::size_t>(workers_.thread_count()));
  DrawStatistics statistics;
  const std::int64_t primitives = geometry_stages.primitives();
  const std::int64_t per_chunk = geometry_stages.primitives_per_chunk();
  const std::int64_t per_batch = kChunksPerThread * workers.thread_count() * per_chunk, batches = (primitives + per_batch - 1) / per_batch;
  std::uint32_t stipple_start = 0;
  for (std::int64_t batch = 0; batch < batches; ++batch) {
    const std::int64_t first = per_batch * in_draw_order(batch, batches, job.order);
    // Stages 1 to 5, chunk by chunk; each chunk has one owner.
    const std::int64_t in_flight = std::min(primitives - first, per_batch);
    const std::int64_t chunk_count = (in_flight + per_chunk - 1) / per_chunk;
    while (static_cast<std::int64_t>(chunks_.size()) < chunk_count) chunks_.push_back(std::make_unique<Chunk>());
    tap.begin_batch(first, per_chunk, chunk_count, target.tile_count());
    parallel_for(workers, chunk_count, [&](std::int64_t i, int) {
      Chunk& chunk = *chunks_[static_cast<std::size_t>(i)];
      chunk.range = {first + i * per_chunk, static_cast<int>(std::min(in_flight - i * per_chunk, per_chunk))};
      tap.begin(chunk);
      geometry_stages(chunk, target, tap);
    });
    const std::span chunks(chunks_.data(), static_cast<std::size_t>(chunk_count));
    for (const auto& chunk : chunks) stipple_start = geometry_stages.continue_stipple(*chunk, stipple_start);

    // Stages 6 to 9, tile by tile; each tile has one owner, who walks the chunks in order: that of
    // submission, or where it makes no difference the other way round. Everyday draws have the
    // fragment stages fused around the program, others run them one by one.
    const TileRange touched = touched_tiles(chunks);
    parallel_for(workers, touched.end - touched.first, [&](std::int64_t place, int worker) {
      const std::int64_t number = touched.first + place;
      tap.begin_tile(number);
      const Tile tile = target.tile(static_cast<int>(number));
      std::vector<FragmentBlock>& blocks = blocks_[static_cast<std::size_t>(worker)];
      for (std::int64_t i = 0; i < chunk_count; ++i) {
        const Chunk& chunk = *chunks[static_cast<std::size_t>(in_draw_order(i, chunk_count, job.order))];
        const auto listed = chunk.tiles.of_tile(static_cast<int>(number));
        if (listed.empty()) continue;
        if (fused) program.draw_tile(job, tile, visibility_.of_tile(number), chunk.view(), listed);
        else fragment_stages(chunk, listed, tile, blocks, counters[static_cast<std::size_t>(number)], tap);
      }
      tap.end_tile(number);
    });
    for (const auto& chunk : chunks) statistics += chunk->statistics;
  }
  for (const FragmentCounters& tile : counters) statistics += tile.statistics();
  return statistics;
}

void Pipeline::clear(RenderTarget& target, const Rgba32F& colour, float depth) {
  target.clear_colour(colour, workers_);
  target.clear_depth(depth, workers_);
}

}  // namespace tuberia
