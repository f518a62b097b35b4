#pragma once
// From a description to its picture.

#include "reference/ray_tracer/render.hpp"

namespace tuberia::tracer {

/// The picture that a description asks for: its camera, size, depth and sampling. Errors: those of TracedScene::create, and of the camera.
Result<TracedPicture> trace_scene(const SceneDescription& scene, Workers& workers, const TracedSceneOptions& options = {}, const TraceProgress& progress = {});

}  // namespace tuberia::tracer
