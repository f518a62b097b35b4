#include "scene/content/light_points.hpp"

namespace tuberia {

std::vector<glm::dvec3> points_of_area(const description::Light& light) {
  const glm::dvec3 corner = light.position - 0.5 * (light.edge_u + light.edge_v);
  std::vector<glm::dvec3> points;
  for (int j = 0; j < light.samples; ++j)
    for (int i = 0; i < light.samples; ++i) points.push_back(corner + (i + 0.5) / light.samples * light.edge_u + (j + 0.5) / light.samples * light.edge_v);
  return points;
}

}  // namespace tuberia
