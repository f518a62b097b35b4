#pragma once
// Pictures of traced rays: sampling, filtering, tiles.                          [B 5.8] [C]

#include <functional>

#include "image/image.hpp"
#include "reference/ray_tracer/ray_tracer.hpp"
#include "reference/ray_tracer/viewing.hpp"
#include "scene/description/tracing.hpp"

namespace tuberia::tracer {

/// How far along, 0..1, and how long it will still take, in seconds, as far as can be told.
using TraceProgress = std::function<void(double done, double seconds_left)>;

struct TraceCounts {
  std::int64_t eye_rays = 0, reflected_rays = 0, transmitted_rays = 0, shadow_rays = 0;
  TraversalWork work;
};

struct TracedPicture {
  Image<Rgba32F> light;  // linear, not exposed; alpha 1
  TraceCounts counts;
};

/// The same bits for any number of workers.
TracedPicture render(const RayTracer& tracer, const View& view, int width, int height, const description::Sampling& sampling, Workers& workers,
                     const TraceProgress& progress = {});

}  // namespace tuberia::tracer
