#pragma once
// Times two peers against one another, frame by frame in turns, so that whatever else the machine
// does meets both.

#include <string>

#include "bench/peers/peer.hpp"

namespace tuberia::bench {

/// Milliseconds a frame. The ratio is the median, over all rounds, of the second peer's time divided
/// by the first's: above 1 the first peer is faster. The quartiles say how far the rounds disagree.
struct Timing {
  std::string workload;
  double first_median_ms = 0, first_smallest_ms = 0;
  double second_median_ms = 0, second_smallest_ms = 0;
  double ratio = 0, lower_quartile = 0, upper_quartile = 0;
  int rounds = 0;
};

/// A round is a frame of each. Runs rounds until the slower peer has been timed for `seconds`, and at
/// least `fewest_rounds`. Each timed frame comes right after an untimed one of the same peer, which
/// wakes its threads and fills the caches, as in a program that draws frame after frame; who begins
/// changes with every round. Both peers must have prepared this workload.
Timing time_in_turns(const Workload& workload, Peer& first, Peer& second, double seconds, int fewest_rounds);

}  // namespace tuberia::bench
