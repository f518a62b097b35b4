#include "scene/frame/frame_lights.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/area_light.hpp"

namespace tuberia {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

/// From its middle to its corner.
AreaLight area_of(const description::Light& from, const Light& light) {
  return {.corner = glm::vec3(from.position - (from.edge_u + from.edge_v) * 0.5), .edge_u = glm::vec3(from.edge_u), .edge_v = glm::vec3(from.edge_v),
          .intensity = from.intensity, .falloff = light.falloff, .falloff_distance = light.falloff_distance};
}

}  // namespace

Result<std::vector<Light>> lights_of(const description::Light& from) {
  using Kind = description::Light::Kind;
  Light light{.kind = Light::Kind::point, .towards = glm::vec3(from.position), .intensity = from.intensity};
  light.falloff = static_cast<Falloff>(from.falloff);
  light.falloff_distance = static_cast<float>(from.falloff_distance);
  if (from.kind == Kind::area) return point_lights_of(area_of(from, light), from.samples);
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
  return std::vector<Light>{light};
}

}  // namespace tuberia
