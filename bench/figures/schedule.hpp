#pragma once
// What a draw would take on more threads than this machine has, from what its parts took on one.

#include <span>
#include <vector>

namespace tuberia::bench {

/// The durations of a loop's items, which may run side by side. The next loop begins when all are done.
using Loop = std::vector<double>;

/// How long the loop takes when each thread that becomes free takes the next item. threads: 1 or more.
double makespan(std::span<const double> items, int threads);

/// Loops one after the other, and time in which one thread works alone. All in one unit.
struct Work {
  std::vector<Loop> loops;
  double alone = 0;

  double total() const;
  /// What no number of threads can beat: the time alone and the longest item of each loop.
  double longest_chain() const;
  double duration(int threads) const;
  /// Which part of the threads' time is work, in (0, 1]: total / (threads * duration).
  double balance(int threads) const { return total() / (threads * duration(threads)); }
};

}  // namespace tuberia::bench
