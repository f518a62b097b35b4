#pragma once
// The lights of a scene as the pipeline has them.

#include <vector>

#include "base/result.hpp"
#include "pipeline/lighting.hpp"
#include "scene/description/scene_description.hpp"

namespace tuberia {

/// The points, or the one direction, that stand for a light: samples x samples of an area, in equal
/// parts of its intensity, each in the middle of its part. Error of point_lights_of.
Result<std::vector<Light>> lights_of(const description::Light& light);

}  // namespace tuberia
