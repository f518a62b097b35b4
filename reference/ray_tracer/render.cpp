#include "reference/ray_tracer/render.hpp"

#include <utility>
#include <vector>

namespace tuberia::tracer {

TracedPicture render(const RayTracer& tracer, const View& view, int width, int height, const description::Sampling& sampling, Workers& workers,
                     const TraceProgress& progress) {
  std::vector<TraceScratch> scratch(static_cast<std::size_t>(workers.thread_count()));
  const double spacing = SamplePattern(sampling).spacing();
  const auto light_at = [&](const glm::dvec2& point, int worker) {
    const NeighbourRays neighbours{.right = view.ray(point + glm::dvec2(spacing, 0)), .down = view.ray(point + glm::dvec2(0, spacing))};
    return tracer.radiance(view.ray(point), scratch[static_cast<std::size_t>(worker)], nullptr, &neighbours);
  };
  SampledPicture sampled = sample_picture(light_at, width, height, sampling, workers, progress);

  TracedPicture picture{.light = std::move(sampled.light), .counts = {}};
  picture.counts.eye_rays = sampled.questions;
  for (const TraceScratch& of_worker : scratch) {
    picture.counts.reflected_rays += of_worker.reflected_rays;
    picture.counts.transmitted_rays += of_worker.transmitted_rays;
    picture.counts.shadow_rays += of_worker.shadow_rays;
    picture.counts.unfollowed_rays += of_worker.unfollowed_rays;
    picture.counts.work += of_worker.traversal.work;
  }
  return picture;
}

}  // namespace tuberia::tracer
