#include "reference/ray_tracer/surface_material.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "math/bump.hpp"
#include "scene/content/material_constants.hpp"

namespace tuberia::tracer {
namespace {

using BumpKind = description::Bump::Kind;

/// The shorter way from one longitude to another, in turns.
glm::dvec2 shorter_way(glm::dvec2 step) {
  step.x -= std::round(step.x);
  return step;
}

/// The larger of two steps, for each coordinate.
glm::dvec2 width_of(const TextureFootprint& footprint) { return glm::max(glm::abs(footprint.right), glm::abs(footprint.down)); }

/// How many rings or veins, turbulence left out, lie between the axis and a point of the pattern's space.
double bands_to(const Pattern& pattern, const glm::dvec3& point) {
  return static_cast<double>(pattern.scale) * (pattern.kind == Pattern::Kind::wood ? std::hypot(point.x, point.z) : point.x);
}

}  // namespace

SurfaceMaterial::SurfaceMaterial(const description::Material& material, Pictures pictures, const glm::dvec3& eye)
    : material_(material), constants_(constants_of(material)), pictures_(std::move(pictures)), eye_(eye) {
  if (material.pattern) pattern_ = pattern_of(*material.pattern);
}

bool SurfaceMaterial::lets_light_through() const noexcept {
  return material_.alpha < 1 || material_.transmission != glm::vec3(0) || (pictures_.alpha_cutoff > 0 && pictures_.colour != nullptr);
}

PointMaterial SurfaceMaterial::at(const SurfacePoint& point, const TextureFootprint& footprint) const noexcept {
  const Place place = place_of(point, footprint);
  const glm::dvec4 own = own_colour(point, place);
  PointMaterial here{.reflection = constants_};
  here.reflection.ambient *= glm::vec3(own);
  here.reflection.diffuse *= glm::vec3(own);
  here.normal = normal_at(point, place);
  here.mirrored = material_.mirror;
  here.transmitted = material_.transmission;
  here.refractive_index = glm::dot(glm::dvec3(material_.refractive_index), glm::dvec3(1)) / 3;
  here.shadow_density = material_.shadow_density;
  // A picture's alpha counts where the material is not opaque anyway, and for holes: as the pipeline has it.
  here.alpha = material_.alpha < 1 ? material_.alpha * own.a : 1;
  here.is_cut_out = pictures_.alpha_cutoff > 0 && material_.alpha * own.a < pictures_.alpha_cutoff;
  here.two_sided = material_.two_sided || material_.transmission != glm::vec3(0);
  return here;
}

SurfaceMaterial::Place SurfaceMaterial::place_of(const SurfacePoint& point, const TextureFootprint& footprint) const noexcept {
  Place place{.uv = point.texcoord, .tangent = point.tangent, .bitangent = point.bitangent, .footprint = footprint, .steps = point_footprint(point, footprint)};
  if (globe_) place = place_on_globe(point, place);
  place.uv *= repeat_;
  place.tangent /= repeat_.x;
  place.bitangent /= repeat_.y;
  place.footprint = {.right = place.footprint.right * repeat_, .down = place.footprint.down * repeat_};
  return place;
}

/// By differences, since coordinates of directions are no simple function of the surface's own.
SurfaceMaterial::Place SurfaceMaterial::place_on_globe(const SurfacePoint& point, Place place) const noexcept {
  const auto coordinates_of = [&](const glm::dvec3& world) {
    const glm::dvec3 object(globe_->object_from_world * glm::dvec4(world, 1));
    const glm::dvec2 up = globe_->coordinates(object, glm::normalize(object));
    return glm::dvec2(up.x, 1 - up.y);
  };
  place.uv = coordinates_of(point.position);
  place.footprint.right = shorter_way(coordinates_of(point.position + place.steps.right) - place.uv);
  place.footprint.down = shorter_way(coordinates_of(point.position + place.steps.down) - place.uv);
  if (!material_.bump) return place;

  // d(u, v) by the surface's own coordinates (s, t), and the inverse of that.
  constexpr double kStep = 1e-5;
  const auto change_along = [&](const glm::dvec3& direction) {
    return shorter_way(coordinates_of(point.position + kStep * direction) - coordinates_of(point.position - kStep * direction)) / (2 * kStep);
  };
  const glm::dvec2 by_s = change_along(point.tangent), by_t = change_along(point.bitangent);
  const double determinant = by_s.x * by_t.y - by_s.y * by_t.x;
  place.tangent = (by_t.y * point.tangent - by_s.y * point.bitangent) / determinant;
  place.bitangent = (by_s.x * point.bitangent - by_t.x * point.tangent) / determinant;
  return place;
}

glm::dvec4 SurfaceMaterial::own_colour(const SurfacePoint& point, const Place& place) const noexcept {
  const glm::dvec4 vertices(point.colour, 1);
  if (pictures_.colour != nullptr && pictures_.texel_distance)
    return vertices * pictures_.colour->at_level(place.uv, std::log2(glm::length(point.position - eye_) / *pictures_.texel_distance));
  if (pictures_.colour != nullptr) return vertices * pictures_.colour->at(place.uv, place.footprint);
  return pattern_.kind == Pattern::Kind::none ? vertices : vertices * glm::dvec4(pattern_colour_at(point, place), 1);
}

glm::dvec3 SurfaceMaterial::pattern_colour_at(const SurfacePoint& point, const Place& place) const noexcept {
  PatternPlace at{.texcoord = place.uv, .world = point.position, .texcoord_width = width_of(place.footprint)};
  if (!is_of_texture_coordinates(pattern_)) {
    const glm::dmat4 pattern_from_world(pattern_.pattern_from_world);
    const auto bands = [&](const glm::dvec3& world) { return bands_to(pattern_, glm::dvec3(pattern_from_world * glm::dvec4(world, 1))); };
    const double here = bands(point.position);
    at.band_width = std::max(std::abs(bands(point.position + place.steps.right) - here), std::abs(bands(point.position + place.steps.down) - here));
  }
  return pattern_colour(pattern_, at);
}

glm::dvec3 SurfaceMaterial::normal_at(const SurfacePoint& point, const Place& place) const noexcept {
  if (!material_.bump || material_.bump->gain == 0) return point.normal;
  const description::Bump& bump = *material_.bump;
  const SurfaceFrame frame{.tangent = place.tangent, .bitangent = place.bitangent, .normal = point.normal};
  if (bump.kind != BumpKind::normal_map) return perturbed_normal(frame, bump.gain * slope_at(place));
  const glm::dvec3 code(pictures_.relief->at(place.uv, place.footprint));
  return mapped_normal(frame, 2.0 * code - 1.0, bump.gain);
}

glm::dvec2 SurfaceMaterial::slope_at(const Place& place) const noexcept {
  const description::Bump& bump = *material_.bump;
  switch (bump.kind) {
    case BumpKind::waves: return waves(place.uv, bump.scale).slope;
    case BumpKind::orange: return orange(place.uv, bump.scale, bump.seed).slope;
    case BumpKind::rough: return rough(place.uv, bump.scale, bump.seed).slope;
    case BumpKind::height_texture:
    case BumpKind::normal_map: break;
  }
  // Over a texel of the finest level each way.                                                       [A 1.2]
  const auto height = [&](double u, double v) { return pictures_.relief->at({u, v}, place.footprint).r; };
  return central_differences(height, place.uv, 1.0 / glm::dvec2(pictures_.relief->size()), 1);
}

}  // namespace tuberia::tracer
