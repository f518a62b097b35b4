// The order of the stages, written once. Each stage is explained in its own file.

#include "pipeline/pipeline.hpp"

#include <algorithm>

#include "pipeline/clipping.hpp"
#include "pipeline/culling.hpp"
#include "pipeline/culling.hpp"
#include "pipeline/fragment_stages.hpp"
#include "pipeline/observer.hpp"
#include "pipeline/perspective_divide.hpp"
#include "pipeline/primitive_assembly.hpp"
#include "pipeline/rasterization.hpp"
#include "pipeline/validate.hpp"
#include "pipeline/vertex_transform.hpp"

namespace tuberia {
namespace {

// At once in flight: enough for many threads, little enough for the last cache.
constexpr std::int64_t kChunksInFlight = 128;

/// Stages 1 to 5, and the setup of 6, on one chunk of primitives.
template <class Tap>
struct Geometry {
  const DrawCall& draw;
  VertexTransform vertex_transform;
  PrimitiveAssembly primitive_assembly;
  Clipping clipping;
  PerspectiveDivide perspective_divide;
  Culling culling;
  Rasterization rasterization;
  const Tap& tap;

  void operator()(Chunk& chunk, const RenderTarget& target) const {
    chunk.fetch(draw.mesh, draw.state.assembly.topology, chunk.range, chunk.vertices, chunk.slots);
    vertex_transform.positions(draw.mesh, chunk.vertices);                         // object -> clip space
    tap.after(Stage::vertex_transform, chunk);
    primitive_assembly(chunk.slots, chunk.range, chunk.triangles);                 // vertices -> triangles
    tap.after(Stage::primitive_assembly, chunk);
    const int clipped = clipping(chunk.vertices, chunk.triangles);                 // clip -> clip
    const int after_clipping = chunk.triangles.count;
    tap.after(Stage::clipping, chunk);
    perspective_divide(chunk.vertices);                                            // clip -> ndc -> screen
    tap.after(Stage::perspective_divide, chunk);
    culling(chunk.vertices, chunk.triangles);                                      // screen -> screen
    tap.after(Stage::culling, chunk);
    vertex_transform.attributes(draw.mesh, draw.program.interface().attributes(), chunk.triangles, chunk.vertices);
    tap.after(Stage::vertex_attributes, chunk);
    rasterization.set_up(chunk.triangles, chunk.vertices, chunk.screen_triangles);
    tap.after(Stage::set_up, chunk);
    rasterization.bin(chunk.screen_triangles, target.tiles_per_row(), target.tile_rows(), chunk.tiles);
    chunk.statistics = {.triangles_in = chunk.range.count, .vertices = static_cast<std::int64_t>(chunk.vertices.source.size()),
                        .triangles_clipped = clipped, .triangles_after_clipping = after_clipping,
                        .triangles_drawn = chunk.triangles.count};
  }
};

}  // namespace

Pipeline::Pipeline(const PipelineOptions& options) : options_(options), workers_(options.threads) {
  TUBERIA_ASSERT(is_supported(options.instruction_set), "this machine lacks the instruction set");
}

Result<DrawStatistics> Pipeline::draw(RenderTarget& target, const DrawCall& draw_call) {
  const Result<AcceptedDraw> accepted = validate(draw_call, target, workers_);     // stage 0
  if (!accepted) return accepted.error();
  return run(target, draw_call, *accepted, workers_, NoTap{});
}

Result<DrawStatistics> Pipeline::draw(RenderTarget& target, const DrawCall& draw_call, Observer& observer) {
  const Result<AcceptedDraw> accepted = validate(draw_call, target, workers_);
  if (!accepted) return accepted.error();
  observer.begin(draw_call, *accepted);
  Workers one(1);
  const DrawStatistics statistics = run(target, draw_call, *accepted, one, ObserverTap{observer});
  observer.end(statistics);
  return statistics;
}

template <class Tap>
DrawStatistics Pipeline::run(RenderTarget& target, const DrawCall& draw_call, const AcceptedDraw& accepted, Workers& workers, const Tap& tap) {
  const PipelineState& state = draw_call.state;
  const auto [isa, precision] = std::pair{options_.instruction_set, options_.precision};
  const ClipLimits limits = clip_limits(accepted.viewport, state.clipping.volume);
  const ScreenMap map = screen_map(accepted.viewport, state.viewport.depth_range, state.clipping.volume);
  const Geometry<Tap> geometry{draw_call, {state.transform, limits, isa}, PrimitiveAssembly(state.assembly), Clipping(limits),
                               {map, isa}, {state.culling, accepted.clip, isa}, {accepted.clip, isa, precision}, tap};
  const FragmentJob job{accepted.output, draw_call.program.uniforms(), state.rasterization.flat_shading};
  const ProgramKernels& program = draw_call.program.interface().kernels(isa, precision);
  const FragmentStages fragment_stages(job, draw_call.program.interface(), isa, precision);
  const bool fused = !Tap::kWatches && !draw_call.count_fragments && accepted.is_everyday;
  std::vector<FragmentCounters> counters(fused ? 0 : static_cast<std::size_t>(target.tile_count()));

  DrawStatistics statistics;
  const std::int64_t primitives =
      primitive_count(state.assembly.topology, static_cast<std::int64_t>(draw_call.mesh.element_count()));
  for (std::int64_t first = 0; first < primitives; first += kChunksInFlight * kPrimitivesPerChunk) {
    // Geometry, chunk by chunk; each chunk has one owner.
    const std::int64_t in_flight = std::min(primitives - first, kChunksInFlight * kPrimitivesPerChunk);
    const std::int64_t chunk_count = (in_flight + kPrimitivesPerChunk - 1) / kPrimitivesPerChunk;
    while (static_cast<std::int64_t>(chunks_.size()) < chunk_count) chunks_.push_back(std::make_unique<Chunk>());
    parallel_for(workers, chunk_count, [&](std::int64_t i, int) {
      Chunk& chunk = *chunks_[static_cast<std::size_t>(i)];
      chunk.range = {first + i * kPrimitivesPerChunk,
                     static_cast<int>(std::min<std::int64_t>(in_flight - i * kPrimitivesPerChunk, kPrimitivesPerChunk))};
      geometry(chunk, target);
    });

    // Stages 6 to 9, tile by tile; each tile has one owner, who walks the chunks in order, so that
    // every pixel sees its triangles in the order of submission. Everyday draws have the fragment
    // stages fused around the program, others run them one by one.
    parallel_for(workers, target.tile_count(), [&](std::int64_t number, int) {
      const Tile tile = target.tile(static_cast<int>(number));
      std::vector<FragmentBlock> blocks;
      for (std::int64_t i = 0; i < chunk_count; ++i) {
        const Chunk& chunk = *chunks_[static_cast<std::size_t>(i)];
        const auto listed = chunk.tiles.of_tile(static_cast<int>(number));
        if (listed.empty()) continue;
        if (fused) program.draw_tile(job, tile, chunk.view(), listed);
        else fragment_stages(chunk, listed, tile, blocks, counters[static_cast<std::size_t>(number)], tap);
      }
    });
    for (std::int64_t i = 0; i < chunk_count; ++i) statistics += chunks_[static_cast<std::size_t>(i)]->statistics;
  }
  for (const FragmentCounters& tile : counters) statistics += tile.statistics();
  return statistics;
}

void Pipeline::clear(RenderTarget& target, const Rgba32F& colour, float depth) {
  target.clear_colour(colour, workers_);
  target.clear_depth(depth, workers_);
}

}  // namespace tuberia
