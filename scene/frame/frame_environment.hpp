#pragma once
// The surroundings of a scene as a map that programs can read.

#include "base/result.hpp"
#include "math/camera.hpp"
#include "pipeline/programs/environment_map.hpp"
#include "scene/description/scene_description.hpp"
#include "scene/environment/render_cube.hpp"

namespace tuberia {

/// The map of the kind that the environment wants, converted to it where its source is another. draw_scene: for
/// one that is rendered. camera: the observer's, whose axes a sphere map has.
/// Errors: of the files' readers, of render_cube, and sizes that textures cannot have.
Result<EnvironmentMap> environment_map_of(const SceneDescription& scene, const description::Environment& environment, const Camera& camera,
                                          Pipeline& pipeline, const DrawScene& draw_scene);

}  // namespace tuberia
