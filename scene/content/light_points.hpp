#pragma once
// The points that stand for a light that is an area.

#include <glm/vec3.hpp>
#include <vector>

#include "scene/description/light.hpp"

namespace tuberia {

/// The middles of samples x samples equal parts of its parallelogram, world space, along u first; each has its equal part of
/// the intensity.                                                                     [B 2.1]
std::vector<glm::dvec3> points_of_area(const description::Light& light);

}  // namespace tuberia
