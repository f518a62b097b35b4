#pragma once
// What a draw would take on more threads than this machine has, from what its parts took on one.

#include <span>
#include <vector>

namespace tuberia::bench {

/// The durations of a loop's items, which may run side by side. The next loop begins when all are done.
using Loop = std::vector<double>;

/// How long the loop takes when each thread that becomes free takes the next item. threads: 1 or more.
double makespan(std::span<const double> items, int threads);

/// A part of a draw: chunks of triangles side by side, then tiles.
struct Batch {
  Loop chunks, tiles;  // as many tiles in every batch of a draw
};

/// How long the batches of a draw take: who is free takes a tile, or else a chunk of the next batch, as far as there is memory to
/// go ahead. The rules are those of base/parallel_batches.cpp, but tiles are dealt one by one, and batches in the order of submission.
double duration_of(std::span<const Batch> draw, int threads);

/// A frame: loops, then draws, one after the other, and time in which one thread works alone. All in
/// one unit. The batches are those of one thread: a draw on n threads makes n of them into one.
struct Work {
  std::vector<Loop> loops{};
  std::vector<std::vector<Batch>> draws{};
  double alone = 0;

  double total() const;
  double duration(int threads) const;
  /// What so many threads cannot beat, however fast each is at finding work: the time alone, the longest item of each loop and
  /// of each batch's tiles, and before a draw's first tiles its first batch's longest chunk.
  double longest_chain(int threads) const;
  /// Which part of the threads' time is work, in (0, 1]: total / (threads * duration).
  double balance(int threads) const { return total() / (threads * duration(threads)); }

 private:
  /// The batches that n threads make of a draw's.
  static std::vector<Batch> joined(std::span<const Batch> draw, int threads);
};

}  // namespace tuberia::bench
