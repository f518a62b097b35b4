#pragma once
// Whatever finds the nearest of many triangles, as the comparison sees it.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/parallel_for.hpp"
#include "bench/trace/ray_sets.hpp"

namespace tuberia::bench {

class RayKernel {
 public:
  virtual ~RayKernel() = default;
  virtual std::string name() const = 0;
  /// As many hits as rays. May be called by several threads at once.
  virtual void find(std::span<const tracer::FastRay> rays, std::span<tracer::FastHit> hits) const = 0;
  /// How many times too slow to be given all the rays: of so many parts of them it traces one.
  virtual int patience() const { return 1; }

  double build_seconds = 0;
  std::int64_t memory_bytes = 0;
};

using RayKernels = std::vector<std::unique_ptr<RayKernel>>;

/// Ours: the fast kernel's rays one by one and 16 at a time, and the tracer in doubles with its hierarchy of boxes.
RayKernels our_kernels(const TriangleSoup& triangles, int threads);

/// Embree's [Embree] rays one by one, the same without its cracks between triangles, and 16 at a time, which it is told are
/// coherent. None where it was not found
/// when this was configured. The triangles must outlive them.
RayKernels embree_kernels(const TriangleSoup& triangles, int threads);

/// Its version and what it runs on; empty where it was not found.
std::string embree_sentence();

}  // namespace tuberia::bench
