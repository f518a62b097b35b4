#pragma once
// What each accelerator takes for the same rays.

#include <array>
#include <cstdint>
#include <span>

#include "bench/trace/section.hpp"
#include "reference/ray_tracer/accelerators/accelerator.hpp"

namespace tuberia::bench {

inline constexpr std::array kAcceleratorKinds{tracer::AcceleratorKind::none, tracer::AcceleratorKind::bounding_spheres, tracer::AcceleratorKind::bvh,
                                              tracer::AcceleratorKind::grid, tracer::AcceleratorKind::octree};

struct AcceleratorFigures {
  double nanoseconds = 0;  // of a ray, on one thread: processor time
  /// Time of a ray by asking every item, divided by this; and the quartiles of the rounds.
  double speedup = 1, lower_quartile = 1, upper_quartile = 1;
  double item_tests = 0, volume_tests = 0;  // a ray; volumes are boxes or spheres that it was tested against, or voxels that it walked through
  tracer::AcceleratorFacts facts;           // the fastest of several builds
};

/// In the order of kAcceleratorKinds.
struct ComparedAccelerators {
  std::int64_t objects = 0;
  std::array<AcceleratorFigures, kAcceleratorKinds.size()> figures;
  std::int64_t hits_compared = 0, hits_different = 0;  // with those of asking every item, to the last bit
};

/// exhaustive: all the rays ask every item, too, so that all hits are compared; otherwise as many as take a second.
ComparedAccelerators compare_accelerators(const tracer::Items& items, std::span<const tracer::Ray> rays, const TraceOptions& options, bool exhaustive);

}  // namespace tuberia::bench
