#pragma once
// The benchmarks of whole frames: frame/workload/threads/isa/precision; a workload has its size.
// The floor of a frame is the workload "clear".

namespace tuberia::bench {

void register_frames();

}  // namespace tuberia::bench
