#pragma once
// The local model of illumination at a vertex.

#include <glm/vec3.hpp>

#include "reference/oracle/state.hpp"

namespace tuberia::oracle {

/// The light that a point of the world sends to the eye, and the lighting's alpha; the normal is unit or zero.
Colour lit(const Lighting&, const glm::vec3& point, const glm::vec3& normal);

}  // namespace tuberia::oracle
