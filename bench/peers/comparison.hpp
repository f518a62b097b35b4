#pragma once
// Times two peers against one another, frame by frame in turns, so that whatever else the machine
// does meets both.

#include <string>

#include "bench/peers/peer.hpp"

namespace tuberia::bench {

/// Milliseconds a frame. The ratio is the median, over all pairs of neighbouring frames, of the
/// second peer's time divided by the first's: above 1 the first peer is faster.
struct Timing {
  std::string workload;
  double first_median_ms = 0, first_smallest_ms = 0;
  double second_median_ms = 0, second_smallest_ms = 0;
  double ratio = 0;
  int pairs = 0;
};

/// Runs pairs of frames until the slower peer has been timed for `seconds`, and at least seven.
/// Each timed frame comes right after an untimed one of the same peer, which wakes its threads and
/// fills the caches, as in a program that draws frame after frame; who begins changes with every
/// pair. Both peers must have prepared this workload.
Timing time_in_turns(const Workload& workload, Peer& first, Peer& second, double seconds);

}  // namespace tuberia::bench
