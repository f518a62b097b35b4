#pragma once
// Descriptions that were made by hand.

#include "base/result.hpp"
#include "scene/description/scene_description.hpp"

namespace tuberia {

/// Error unless a scene file could say all of it: the first number out of range or not finite, the first condition
/// between keys that does not hold, or name that is not there, called as in scene files, `materials.red.exponent is -3, but must be
/// 0 or more`. Of constants that do not count (a lambert material's exponent) it says nothing. Files are not looked at.
Result<Nothing> check_scene(const SceneDescription& scene);

}  // namespace tuberia
