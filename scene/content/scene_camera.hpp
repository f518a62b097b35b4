#pragma once
// The observer of a scene as a camera.

#include "base/result.hpp"
#include "math/camera.hpp"
#include "scene/description/camera.hpp"

namespace tuberia {

/// The camera for a picture of this aspect, width / height, at a time from 0 to 1, up to which it has moved.
/// Error for a volume that is none.
Result<Camera> camera_of(const description::Camera& camera, double aspect, double time = 0);

/// Where the lines of sight meet; of a parallel view, a point so far away that they are as good as parallel.
glm::vec3 eye_of(const Camera& camera) noexcept;

}  // namespace tuberia
