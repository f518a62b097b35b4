// Imitation of shading at vertices.                                                              [B 3.1, 3.2]

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "examples/tuberia/witness/imitation.hpp"
#include "scene/content/material_constants.hpp"

namespace tuberia::witness {
namespace {

using tracer::Hit;
using tracer::Ray;
using tracer::SurfacePoint;
using tracer::TraceScratch;

glm::dvec3 clamped(const glm::dvec3& light) { return glm::clamp(light, glm::dvec3(0), glm::dvec3(1)); }

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

}  // namespace

glm::dvec3 Imitation::to_eye(const Ray& ray, const glm::dvec3& point) const { return grid_.is_parallel() ? -ray.direction : glm::normalize(ray.origin - point); }

/// Vertices are lit without textures, which are multiplied in at fragments.
Imitation::Fragment Imitation::without_texture(Fragment fragment) const {
  if (!has_texture(fragment.hit)) return fragment;
  const ReflectionConstants constants = constants_of(*material_of(fragment.hit));
  fragment.material.reflection.ambient = constants.ambient * glm::vec3(fragment.at.colour);
  fragment.material.reflection.diffuse = constants.diffuse * glm::vec3(fragment.at.colour);
  return fragment;
}

/// What the texture makes of the light there; 1 where the material has nothing that it could change.
glm::dvec3 Imitation::texel_of(const Fragment& fragment) const {
  glm::dvec3 texel(1);
  if (!has_texture(fragment.hit)) return texel;
  const ReflectionConstants &with = fragment.material.reflection, without = without_texture(fragment).material.reflection;
  for (int c = 0; c < 3; ++c) {
    if (without.diffuse[c] > 0) texel[c] = static_cast<double>(with.diffuse[c]) / without.diffuse[c];
    else if (without.ambient[c] > 0) texel[c] = static_cast<double>(with.ambient[c]) / without.ambient[c];
  }
  return texel;
}

/// Flat, Gouraud and dot-product shading: the corners are lit.                                       [B 3.1, 3.2]
LightRange Imitation::lit_at_vertices(const Place& place, const Ray& ray, const Fragment& here, TraceScratch& scratch) const {
  const Hit& hit = here.hit;
  const description::Shading shading = scene_->description().objects[static_cast<std::size_t>(scene_->object_of(hit.item))].shading;
  std::vector<Fragment> corners;
  for (const glm::dvec2 weights : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)}) {
    Hit corner = hit;
    corner.at = weights;
    const SurfacePoint at = scene_->geometry().surface(ray, corner);
    corners.push_back(without_texture(fragment(hit, at, to_eye(ray, at.position), {})));
  }
  if (shading == description::Shading::dot_product) return lit_by_cosines(hit, corners, scratch);
  const auto light_of = [&](const Fragment& corner) { return clamped(lit_at_fragment(place, corner, {}, scratch).low); };
  if (shading == description::Shading::flat) return LightRange::of(light_of(corners[0]));
  const glm::dvec3 weights(1 - hit.at.x - hit.at.y, hit.at);
  return LightRange::of(texel_of(here) * (weights.x * light_of(corners[0]) + weights.y * light_of(corners[1]) + weights.z * light_of(corners[2])));
}

/// N.L and N.H, or R.V, of each light are interpolated; what a light loses on its way makes them smaller.        [B 3.4]
LightRange Imitation::lit_by_cosines(const Hit& hit, const std::vector<Fragment>& corners, TraceScratch& scratch) const {
  const ReflectionConstants& constants = corners[0].material.reflection;
  const glm::dvec3 weights(1 - hit.at.x - hit.at.y, hit.at);
  std::vector<glm::dvec2> cosines(lights_.size(), glm::dvec2(0));
  for (int k = 0; k < 3; ++k) {
    const Fragment& corner = corners[static_cast<std::size_t>(k)];
    scratch.lights.clear();
    scene_->lights(corner.at.position, scratch.lights);
    for (std::size_t i = 0; i < scratch.lights.size(); ++i) {
      const glm::dvec3 &N = corner.normal, &L = scratch.lights[i].to_light, &V = corner.to_eye;
      const double share = largest(lights_[i].intensity) > 0 ? largest(scratch.lights[i].intensity) / largest(lights_[i].intensity) : 0;
      const double highlight = constants.model == Reflection::phong ? glm::dot(2 * glm::dot(N, L) * N - L, V) : glm::dot(N, glm::normalize(L + V));
      const double power_of_share = constants.exponent > 0 ? std::pow(share, 1 / static_cast<double>(constants.exponent)) : 1;
      cosines[i] += weights[k] * glm::dvec2(share * glm::dot(N, L), power_of_share * highlight);
    }
  }
  glm::dvec3 sum = glm::dvec3(constants.ambient) * scene_->ambient();
  for (std::size_t i = 0; i < cosines.size(); ++i) {
    if (!(cosines[i].x > 0)) continue;
    const double power = std::pow(std::max(cosines[i].y, 0.0), static_cast<double>(constants.exponent));
    sum += lights_[i].intensity * (glm::dvec3(constants.diffuse) * cosines[i].x + glm::dvec3(constants.specular) * power);
  }
  return LightRange::of(sum);
}

}  // namespace tuberia::witness
