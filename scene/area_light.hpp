#pragma once
// A light that is not a point: as many points in its place.                                [B 2.1]

#include <glm/vec3.hpp>
#include <vector>

#include "base/result.hpp"
#include "pipeline/lighting.hpp"

namespace tuberia {

/// A rectangle that shines to all sides: corner and two edges, world space.
struct AreaLight {
  glm::vec3 corner{0}, edge_u{1, 0, 0}, edge_v{0, 1, 0};
  glm::vec3 intensity{1};            // of all of it together
  Falloff falloff = Falloff::none;
  float falloff_distance = 1;        // as of Light
};

/// Points in the middles of each_way x each_way equal parts, each with its share of the intensity. Error for
/// each_way outside 1 to 64.
Result<std::vector<Light>> point_lights_of(const AreaLight& area, int each_way);

}  // namespace tuberia
