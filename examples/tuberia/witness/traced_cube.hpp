#pragma once
// Surroundings that the pipeline draws from a scene itself, traced.                     [A 1.4] [B 4.1.3]

#include "base/parallel_for.hpp"
#include "base/result.hpp"
#include "scene/description/scene_description.hpp"
#include "scene/environment/surroundings.hpp"

namespace tuberia::witness {

/// The scene from the point that its environment is rendered from: a ray through the middle of each texel, with the techniques
/// that the pipeline has there. Mirrors show nothing. Errors of TracedScene and Imitation.
Result<CubeImages> traced_cube(const SceneDescription& scene, const description::Environment& environment, Workers& workers);

}  // namespace tuberia::witness
