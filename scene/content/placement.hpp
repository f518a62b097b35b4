#pragma once
// Where objects are.

#include <glm/mat4x4.hpp>
#include <vector>

#include "scene/description/transform.hpp"

namespace tuberia {

/// World from object: the steps, the first one first.
glm::dmat4 matrix_of(const std::vector<description::Transform>& steps) noexcept;

/// The same as the pipeline multiplies it, rounded to float after each step.
glm::mat4 float_matrix_of(const std::vector<description::Transform>& steps) noexcept;

}  // namespace tuberia
