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

/// Chunks in parallel, then, when all are done, tiles in parallel.
struct BatchTimes {
  std::int64_t first_primitive = 0, primitives_per_chunk = 1;
  std::vector<ChunkTimes> chunks;
  std::vector<TileTimes> tiles;  // of the target, row by row; those without work take next to nothing
};

/// One draw, or several one after the other.
struct DrawTimes {
  Nanoseconds validation = 0;
  std::vector<BatchTimes> batches;
};

/// Fills in DrawTimes. A stage that is done together with the next one is counted there. Costs one
/// look at the clock (25 ns) a stage of a chunk, and two a tile.
class ClockTap {
 public:
  static constexpr bool kWatches = false;  // the draw takes the way it would take unwatched
  explicit ClockTap(DrawTimes& times) noexcept : times_(times) {}

  void begin_batch(std::int64_t first_primitive, std::int64_t per_chunk, std::int64_t chunks, int tiles) const {
    times_.batches.push_back({.first_primitive = first_primitive, .primitives_per_chunk = per_chunk,
                              .chunks = std::vector<ChunkTimes>(static_cast<std::size_t>(chunks)),
                              .tiles = std::vector<TileTimes>(static_cast<std::size_t>(tiles))});
  }

  // Every chunk and every tile has one owner, so none of these meet.
  void begin(const Chunk& chunk) const noexcept { times_of(chunk).last = Clock::now(); }
  void fetched(const Chunk& chunk) const noexcept { add(TimedStage::fetch, chunk); }
  void after(Stage stage, const Chunk& chunk) const noexcept { add(static_cast<TimedStage>(static_cast<int>(stage) + 1), chunk); }
  void begin_tile(std::int64_t number) const noexcept { times_of(number).begin = Clock::now(); }
  void end_tile(std::int64_t number) const noexcept {
    TileTimes& tile = times_of(number);
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
  ChunkTimes& times_of(const Chunk& chunk) const noexcept {
    BatchTimes& batch = times_.batches.back();
    return batch.chunks[static_cast<std::size_t>((chunk.range.first - batch.first_primitive) / batch.primitives_per_chunk)];
  }
  TileTimes& times_of(std::int64_t tile) const noexcept { return times_.batches.back().tiles[static_cast<std::size_t>(tile)]; }
  void add(TimedStage stage, const Chunk& chunk) const noexcept {
    ChunkTimes& times = times_of(chunk);
    const Clock::time_point now = Clock::now();
    times.stages[static_cast<std::size_t>(stage)] += nanoseconds(now - times.last);
    times.last = now;
  }

  DrawTimes& times_;
};

}  // namespace tuberia
