#include "scene/area_light.hpp"

#include <string>

namespace tuberia {

Result<std::vector<Light>> point_lights_of(const AreaLight& area, int each_way) {
  if (each_way < 1 || each_way > 64) return Error{"an area light of " + std::to_string(each_way) + " points each way; it can be 1 to 64"};
  const auto parts = static_cast<float>(each_way);
  std::vector<Light> points;
  for (int j = 0; j < each_way; ++j)
    for (int i = 0; i < each_way; ++i) {
      const float u = (static_cast<float>(i) + 0.5f) / parts, v = (static_cast<float>(j) + 0.5f) / parts;
      points.push_back({.kind = Light::Kind::point, .towards = area.corner + u * area.edge_u + v * area.edge_v,
                        .intensity = area.intensity / (parts * parts), .falloff = area.falloff, .falloff_distance = area.falloff_distance});
    }
  return points;
}

}  // namespace tuberia
