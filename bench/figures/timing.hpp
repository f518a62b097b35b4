#pragma once
// Timing several ways to do one thing in turns, so that whatever else the machine does meets all of them.

#include <functional>
#include <span>
#include <vector>

namespace tuberia::bench {

/// Of one way. The ratio is the median, over all rounds, of its time divided by that of the first way in the same
/// round; the quartiles say how far the rounds disagree.
struct RelativeTime {
  double median_ms = 0;
  double ratio = 1, lower_quartile = 1, upper_quartile = 1;
  int rounds = 0;
};

struct Effort {
  double seconds = 1.5;  // about, for all ways together
  int fewest_rounds = 7;
  bool of_processor = false;  // the process's processor time, which waits for nobody: for ways that use one thread
};

/// A round times every way once, forwards and backwards by turns; one that takes less than a millisecond and a half as
/// often in a row as makes that, after an untimed run. There is at least one way.
std::vector<RelativeTime> time_in_turns(std::span<const std::function<void()>> ways, const Effort& effort);

}  // namespace tuberia::bench
