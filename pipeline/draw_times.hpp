#pragma once
// Where a draw's time goes, for those who tune the stages: a clock that is read between them.

#include <array>
#include <chrono>
#include <cstdint>
#include <vector>

#include "pipeline/observer.hpp"

namespace tuberia {

/// What the chunks are timed by: fetching vertices, then the stages up to binning.
enum class TimedStage : std::uint8_t {
  fetch, transform, assembly, clipping, divide, culling, attributes, set_up, binning
};
inline constexpr int kTimedStages = 9;
static_assert(static_cast<int>(Stage::binning) + 2 == kTimedStages);

using Nanoseconds = std::int64_t;

struct ChunkTimes {
  std::array<Nanoseconds, kTimedStages> stages{};
  std::chrono::steady_clock::time_point last{};  // when the stage that runs at the moment began

  Nanoseconds total() const noexcept {
    Nanoseconds sum = 0;
    for (const Nanoseconds stage : stages) sum += stage;
    return sum;
  }
};

struct TileTimes {
  Nanoseconds total = 0;
  std::chrono::steady_clock::time_point begin{};
};

/// Chunks in parallel, then, when all are done, tiles in parallel, perhaps beside chunks of the next batch.
struct BatchTimes {
  std::vector<ChunkTimes> chunks;
  std::vector<TileTimes> tiles;  // of the target, row by row; those without work take next to nothing
};

/// One draw, or several one after the other.
struct DrawTimes {
  Nanoseconds validation = 0;
  Nanoseconds bookkeeping = 0;      // making room for what follows: no draw without a clock takes it
  std::vector<BatchTimes> batches;  // of each draw, in the order of its primitives
};

/// Fills in DrawTimes. A stage that is done together with the next one is counted there. Costs one
/// look at the clock (25 ns) a stage of a chunk, and two a tile.
class ClockTap {
 public:
  static constexpr bool kWatches = false;  // the draw takes the way it would take unwatched
  explicit ClockTap(DrawTimes& times) noexcept : times_(times) {}

  /// All times are there before the first chunk begins: the threads are not all in the same batch.
  void begin_draw(const BatchPlan& plan, int tiles) {
    const Clock::time_point begin = Clock::now();
    plan_ = plan;
    first_batch_ = times_.batches.size();
    for (std::int64_t batch = 0; batch < plan.batches(); ++batch)
      times_.batches.push_back({.chunks = std::vector<ChunkTimes>(static_cast<std::size_t>(plan.chunks(batch))),
                                .tiles = std::vector<TileTimes>(static_cast<std::size_t>(tiles))});
    times_.bookkeeping += nanoseconds(Clock::now() - begin);
  }

  // Every chunk and every tile has one owner, so none of these meet.
  void begin(const Chunk& chunk) const noexcept { times_of(chunk).last = Clock::now(); }
  void fetched(const Chunk& chunk) const noexcept { add(TimedStage::fetch, chunk); }
  void after(Stage stage, const Chunk& chunk) const noexcept { add(static_cast<TimedStage>(static_cast<int>(stage) + 1), chunk); }
  void begin_tile(std::int64_t batch, std::int64_t number) const noexcept { times_of(batch, number).begin = Clock::now(); }
  void end_tile(std::int64_t batch, std::int64_t number) const noexcept {
    TileTimes& tile = times_of(batch, number);
    tile.total += nanoseconds(Clock::now() - tile.begin);
  }

  // Fragment stages are not told apart: the everyday ones are one loop.
  static void before(Stage, const Chunk&, const FragmentBlock&, const Tile&) noexcept {}
  static void after(Stage, const Chunk&, const FragmentBlock&, const Tile&) noexcept {}

 private:
  using Clock = std::chrono::steady_clock;

  static Nanoseconds nanoseconds(Clock::duration duration) noexcept {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(duration).count();
  }
  BatchTimes& times_of(std::int64_t batch) const noexcept { return times_.batches[first_batch_ + static_cast<std::size_t>(batch)]; }
  ChunkTimes& times_of(const Chunk& chunk) const noexcept {
    const std::int64_t number = chunk.range.first / plan_.primitives_per_chunk;
    return times_of(number / plan_.chunks_per_batch).chunks[static_cast<std::size_t>(number % plan_.chunks_per_batch)];
  }
  TileTimes& times_of(std::int64_t batch, std::int64_t tile) const noexcept { return times_of(batch).tiles[static_cast<std::size_t>(tile)]; }
  void add(TimedStage stage, const Chunk& chunk) const noexcept {
    ChunkTimes& times = times_of(chunk);
    const Clock::time_point now = Clock::now();
    times.stages[static_cast<std::size_t>(stage)] += nanoseconds(now - times.last);
    times.last = now;
  }

  DrawTimes& times_;
  BatchPlan plan_;
  std::size_t first_batch_ = 0;  // of this draw, in times_
};

}  // namespace tuberia
