#pragma once
// The lights of a scene as points of surfaces see them.                                       [B 2.1, 2.5, 2.6]

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.hpp"
#include "math/transforms.hpp"
#include "reference/ray_tracer/texture_lookup.hpp"
#include "scene/description/light.hpp"

namespace tuberia::tracer {

/// A point or direction that light comes from; areas are several.                                    [B 2.5]
struct TracedLight {
  glm::dvec3 to_light{0, 1, 0};        // unit, from the point that is lit; 0 at the light itself
  double distance = kInfinity;
  glm::dvec3 intensity{1};             // what arrives, falloff, cone and projection in it
  bool casts_shadows = true;
};

/// A picture in front of a light, as in a slide projector: black outside of it and behind the projector.
struct Slide {
  std::shared_ptr<const TextureLookup> texture;
  glm::dvec3 eye{0};
  CameraBasis basis;
  bool is_parallel = false;
  glm::dvec2 half_size{1};             // of a parallel beam; else at the distance 1

  /// Linear RGB.
  glm::dvec3 thrown_on(const glm::dvec3& point, const PointFootprint& footprint) const noexcept;

 private:
  /// On the picture, (0, 0) its upper left corner; nullopt behind the projector.
  std::optional<glm::dvec2> place_of(const glm::dvec3& point) const noexcept;
};

/// One of the points, or the direction, that a light stands for.
class LightSource {
 public:
  /// What arrives at a point, wherever its surface looks and whatever is in the way; a light that sends nothing there, too.
  TracedLight at(const glm::dvec3& point, const PointFootprint& footprint = {}) const noexcept;

  /// All points of a light. picture: of its projection, if it has one. Error for a projection whose `up` lies along its axis.
  static Result<std::vector<LightSource>> all_of(const description::Light& light, std::shared_ptr<const TextureLookup> picture);

 private:
  explicit LightSource(const description::Light& light);
  double attenuation(double distance, const glm::dvec3& to_light) const noexcept;

  description::Light::Kind kind_;
  description::Light::Falloff falloff_;
  double falloff_distance_;
  glm::dvec3 intensity_;
  bool casts_shadows_;
  glm::dvec3 towards_;                 // directional: unit direction; else the position
  glm::dvec3 axis_{0, 0, -1};          // of a spot, unit
  double cos_inner_ = 1, cos_outer_ = 1;
  std::optional<Slide> slide_;
};

}  // namespace tuberia::tracer
