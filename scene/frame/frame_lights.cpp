#include "scene/frame/frame_lights.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace tuberia {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

std::vector<Light> points_of_area(const description::Light& area, Light light) {
  std::vector<Light> points;
  const int n = area.samples;
  light.intensity = area.intensity / static_cast<float>(n * n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const glm::dvec2 at((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5);
      light.towards = glm::vec3(area.position + at.x * area.edge_u + at.y * area.edge_v);
      points.push_back(light);
    }
  return points;
}

}  // namespace

std::vector<Light> lights_of(const description::Light& from) {
  using Kind = description::Light::Kind;
  Light light{.kind = Light::Kind::point, .towards = glm::vec3(from.position), .intensity = from.intensity};
  light.falloff = static_cast<Falloff>(from.falloff);
  light.falloff_distance = static_cast<float>(from.falloff_distance);
  if (from.kind == Kind::area) return points_of_area(from, light);
  if (from.kind == Kind::directional) {
    light.kind = Light::Kind::directional;
    light.towards = glm::vec3(glm::normalize(from.towards));
    light.falloff = Falloff::none;
  }
  if (from.kind == Kind::spot) {
    light.kind = Light::Kind::spot;
    light.axis = glm::vec3(glm::normalize(from.look_at - from.position));
    light.cos_inner = static_cast<float>(std::cos(from.full_cone_degrees * kRadiansPerDegree));
    light.cos_outer = static_cast<float>(std::cos(from.cone_degrees * kRadiansPerDegree));
  }
  return {light};
}

}  // namespace tuberia
