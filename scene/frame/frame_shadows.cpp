#include "scene/frame/frame_shadows.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "scene/frame/frame_lights.hpp"
#include "scene/shadows/shadow_pass.hpp"

namespace tuberia {
namespace {

using Kind = description::Light::Kind;

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

/// Any vertical that is not along the axis.
glm::dvec3 up_for(const glm::dvec3& axis) { return std::abs(axis.y) < 0.99 * glm::length(axis) ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1); }

/// How far a box reaches along an axis from a point: the least and the most.
std::pair<double, double> reach_of(const Bounds& box, const glm::dvec3& from, const glm::dvec3& axis) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 at(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y, corner & 4 ? box.upper.z : box.lower.z);
    const double distance = glm::dot(at - from, axis);
    least = std::min(least, distance);
    most = std::max(most, distance);
  }
  return {least, most};
}

/// A camera in the light's place that looks along an axis, with all of the box between near and far.
Result<Camera> perspective_camera(const glm::dvec3& position, const glm::dvec3& look_at, const glm::dvec3& up, double fovy_radians, double aspect, const Bounds& seen) {
  const auto [least, most] = reach_of(seen, position, glm::normalize(look_at - position));
  const double far_distance = most > 0 ? most * 1.01 : 1;
  const auto volume = perspective_volume(fovy_radians, aspect, std::max(least * 0.99, far_distance * 1e-3), far_distance);
  if (!volume) return volume.error();
  return Camera{.eye = position, .point_of_interest = look_at, .up = up, .view = *volume};
}

Result<ShadowMap> map_of(Pipeline& pipeline, const description::Light& from, const Light& light, std::span<const DrawCall> casters, const Bounds& seen) {
  const auto view = shadow_view_of(from, light, seen);
  if (!view) return view.error();
  const ShadowPass pass{.size = from.shadow->resolution};
  return std::visit([&](const auto& seen_from) { return draw_shadow_map(pipeline, casters, seen_from, pass); }, *view);
}

Result<ShadowMap> shadow_of(Pipeline& pipeline, const description::Light& from, const Light& light, std::span<const DrawCall> casters, const Bounds& seen) {
  auto map = map_of(pipeline, from, light, casters, seen);
  if (!map) return map.error();
  map->constant_bias += static_cast<float>(from.shadow->constant_bias);
  map->slope_bias = static_cast<float>(from.shadow->slope_bias);
  map->normal_offset = static_cast<float>(from.shadow->normal_offset);
  map->taps = from.shadow->taps;
  return map;
}

Result<ProjectedTexture> projection_of(const description::Light& light, const FrameTexture& texture, const Bounds& seen) {
  const description::Projection& projection = *light.projection;
  const TextureLevel& picture = texture.texture->level(0);
  const double aspect = static_cast<double>(picture.width) / picture.height;
  Result<Camera> camera = Camera{};
  if (light.kind == Kind::directional) {
    const double half = projection.height / 2;
    const glm::dvec3 axis = glm::normalize(light.towards);
    camera->eye = light.look_at + axis;
    camera->point_of_interest = light.look_at;
    camera->up = projection.up;
    camera->projection = Projection::orthographic;
    camera->view = {.left = -half * aspect, .right = half * aspect, .bottom = -half, .top = half, .near_distance = -1000, .far_distance = 1000};
  } else {
    camera = perspective_camera(light.position, light.look_at, projection.up, projection.fovy_degrees * kRadiansPerDegree, aspect, seen);
  }
  if (!camera) return camera.error();
  const auto view = light_view(*camera);
  if (!view) return view.error();
  ProjectedTexture projected{.texture = texture.texture, .map_from_world = view->map_from_world};
  projected.sampler.texels = texture.sampler.texels;
  projected.sampler.mipmaps = texture.sampler.mipmaps;
  return projected;
}

Result<ShadowView> as_shadow_view(const Result<LightView>& view) { return view ? Result<ShadowView>(*view) : view.error(); }

}  // namespace

Result<ShadowView> shadow_view_of(const description::Light& light, const Light& point, const Bounds& seen) {
  if (light.kind == Kind::spot) {
    const auto camera = perspective_camera(light.position, light.look_at, up_for(light.look_at - light.position), 2 * light.cone_degrees * kRadiansPerDegree, 1, seen);
    return camera ? as_shadow_view(light_view(*camera)) : camera.error();
  }
  const auto view = light_view(point, seen);
  if (view || point.kind == Light::Kind::directional) return as_shadow_view(view);
  const auto cube = light_cube(point, seen);
  return cube ? Result<ShadowView>(*cube) : cube.error();
}

Result<std::vector<SurfaceLight>> lights_with_shadows(Pipeline& pipeline, const description::Light& light, std::span<const DrawCall> casters,
                                                      const Bounds& seen, const FrameTextures& textures) {
  const auto points = lights_of(light);
  if (!points) return points.error();
  std::vector<SurfaceLight> lights;
  for (const Light& point : *points) {
    SurfaceLight& one = lights.emplace_back(SurfaceLight{.light = point});
    if (light.shadow && !casters.empty()) {
      auto map = shadow_of(pipeline, light, point, casters, seen);
      if (!map) return Error{"its shadow: " + map.error().message};
      one.shadow = *std::move(map);
    }
    if (light.projection) {
      auto projected = projection_of(light, textures.at(light.projection->texture), seen);
      if (!projected) return Error{"its projection: " + projected.error().message};
      one.projected = *std::move(projected);
    }
  }
  return lights;
}

}  // namespace tuberia
