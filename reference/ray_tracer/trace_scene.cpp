#include "reference/ray_tracer/trace_scene.hpp"

#include "scene/content/scene_camera.hpp"

namespace tuberia::tracer {

Result<TracedPicture> trace_scene(const SceneDescription& scene, Workers& workers, const TracedSceneOptions& options, const TraceProgress& progress) {
  const int width = scene.picture.width, height = scene.picture.height;
  const auto camera = camera_of(scene.camera, static_cast<double>(width) / height);
  if (!camera) return camera.error();
  const auto view = View::create(*camera, width, height);
  if (!view) return view.error();
  const auto traced = TracedScene::create(scene, workers, options);
  if (!traced) return traced.error();
  const RayTracer tracer(*traced, {.most_level = scene.tracing.depth, .least_weight = scene.tracing.least_weight});
  return render(tracer, *view, width, height, scene.tracing.sampling, workers, progress);
}

}  // namespace tuberia::tracer
