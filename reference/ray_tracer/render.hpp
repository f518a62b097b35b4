#pragma once
// Pictures of traced rays.                                                       [A 2.1] [B 5.8] [C]

#include "reference/ray_tracer/ray_tracer.hpp"
#include "reference/ray_tracer/sampling.hpp"
#include "reference/ray_tracer/viewing.hpp"

namespace tuberia::tracer {

struct TraceCounts {
  std::int64_t eye_rays = 0, reflected_rays = 0, transmitted_rays = 0, shadow_rays = 0, unfollowed_rays = 0;
  TraversalWork work;
};

struct TracedPicture {
  Image<Rgba32F> light;  // linear, not exposed; alpha 1
  TraceCounts counts;
};

/// The view of width x height pixels, as sample_picture() has it. The same bits for any number of workers.
TracedPicture render(const RayTracer& tracer, const View& view, int width, int height, const description::Sampling& sampling, Workers& workers,
                     const TraceProgress& progress = {});

}  // namespace tuberia::tracer
