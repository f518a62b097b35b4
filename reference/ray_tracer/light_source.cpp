#include "reference/ray_tracer/light_source.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/reflection.hpp"
#include "scene/content/light_points.hpp"

namespace tuberia::tracer {
namespace {

using Kind = description::Light::Kind;
using Falloff = description::Light::Falloff;

constexpr double kRadiansPerDegree = std::numbers::pi / 180;
// The limits that docs/conventions.md gives: nearer than the one a light is as bright as there, farther than the other, too.
constexpr double kLeastDistance = 1e-6, kMostDistance = 1e15;
constexpr double kNarrowestEdge = 1e-6;  // of a cone, as a difference of cosines

Result<Slide> slide_of(const description::Light& light, std::shared_ptr<const TextureLookup> picture) {
  const description::Projection& projection = *light.projection;
  Slide slide{.texture = std::move(picture), .basis = {}, .is_parallel = light.kind == Kind::directional};
  slide.eye = slide.is_parallel ? light.look_at + glm::normalize(light.towards) : light.position;
  const auto basis = camera_basis(slide.eye, light.look_at, projection.up);
  if (!basis) return Error{"its projection: " + basis.error().message};
  slide.basis = *basis;
  const glm::dvec2 size(slide.texture->size());
  const double half_height = slide.is_parallel ? projection.height / 2 : std::tan(projection.fovy_degrees * kRadiansPerDegree / 2);
  slide.half_size = half_height * glm::dvec2(size.x / size.y, 1);
  return slide;
}

}  // namespace

std::optional<glm::dvec2> Slide::place_of(const glm::dvec3& point) const noexcept {
  const glm::dvec3 seen = point - eye;
  const double depth = is_parallel ? 1 : -glm::dot(seen, basis.w);
  if (!(depth > 0)) return std::nullopt;
  return glm::dvec2(glm::dot(seen, basis.u), -glm::dot(seen, basis.v)) / (2 * depth * half_size) + 0.5;
}

glm::dvec3 Slide::thrown_on(const glm::dvec3& point, const PointFootprint& footprint) const noexcept {
  const auto at = place_of(point);
  const bool is_inside = at && at->x >= 0 && at->x <= 1 && at->y >= 0 && at->y <= 1;
  if (!is_inside) return glm::dvec3(0);
  const auto right = place_of(point + footprint.right), down = place_of(point + footprint.down);
  return texture->at(*at, {.right = right ? *right - *at : glm::dvec2(0), .down = down ? *down - *at : glm::dvec2(0)});
}

LightSource::LightSource(const description::Light& light)
    : kind_(light.kind), falloff_(light.falloff), falloff_distance_(light.falloff_distance), intensity_(light.intensity),
      casts_shadows_(light.shadow.has_value()), towards_(light.position) {
  if (kind_ == Kind::directional) {
    towards_ = glm::normalize(light.towards);
    falloff_ = Falloff::none;
  }
  if (kind_ != Kind::spot) return;
  axis_ = glm::normalize(light.look_at - light.position);
  cos_outer_ = std::cos(light.cone_degrees * kRadiansPerDegree);
  cos_inner_ = std::max(std::cos(light.full_cone_degrees * kRadiansPerDegree), cos_outer_ + kNarrowestEdge);
}

Result<std::vector<LightSource>> LightSource::all_of(const description::Light& light, std::shared_ptr<const TextureLookup> picture) {
  LightSource source(light);
  std::vector<LightSource> sources;
  if (light.kind == Kind::area) {
    const std::vector<glm::dvec3> points = points_of_area(light);
    source.intensity_ /= static_cast<double>(points.size());
    for (const glm::dvec3& point : points) {
      source.towards_ = point;
      sources.push_back(source);
    }
    return sources;
  }
  if (light.projection) {
    auto slide = slide_of(light, std::move(picture));
    if (!slide) return slide.error();
    source.slide_ = *std::move(slide);
  }
  sources.push_back(std::move(source));
  return sources;
}

TracedLight LightSource::at(const glm::dvec3& point, const PointFootprint& footprint) const noexcept {
  TracedLight light{.intensity = intensity_, .casts_shadows = casts_shadows_};
  if (kind_ == Kind::directional) {
    light.to_light = towards_;
  } else {
    const glm::dvec3 way = towards_ - point;
    light.distance = glm::length(way);
    light.to_light = light.distance > 0 ? way / light.distance : glm::dvec3(0);
    light.intensity *= attenuation(light.distance, light.to_light);
  }
  if (slide_) light.intensity *= slide_->thrown_on(point, footprint);
  return light;
}

/// Falloff times the cone's share, a smoothstep between its two cosines.
double LightSource::attenuation(double distance, const glm::dvec3& to_light) const noexcept {
  const double d = std::min(distance, kMostDistance);
  double share = 1;
  if (falloff_ == Falloff::linear) share = linear_falloff(std::max(d + falloff_distance_, kLeastDistance), 0);
  if (falloff_ == Falloff::inverse_square) share = inverse_square_falloff(std::max(d, kLeastDistance));
  if (kind_ != Kind::spot) return share;
  const double t = std::clamp((-glm::dot(to_light, axis_) - cos_outer_) / (cos_inner_ - cos_outer_), 0.0, 1.0);
  return share * t * t * (3 - 2 * t);
}

}  // namespace tuberia::tracer
