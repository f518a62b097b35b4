#pragma once
// What a shadow map would say, found by rays from the light through the middles of its texels.          [A 1.3] docs/shadows.md

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "examples/tuberia/witness/light_range.hpp"
#include "math/transforms.hpp"
#include "reference/ray_tracer/ray.hpp"
#include "scene/description/light.hpp"
#include "scene/frame/frame_shadows.hpp"

namespace tuberia::witness {

/// A surface where a light falls on it. The normal is without relief, on the eye's side if there are two; unit.
struct ShadowedPoint {
  glm::dvec3 position{0}, normal{0, 1, 0}, to_light{0, 1, 0};
};

class RetracedShadow {
 public:
  /// How far along a ray the nearest caster of shadows is; infinite without one.
  using NearestCaster = std::function<double(const tracer::Ray&)>;

  RetracedShadow(const description::Shadow& shadow, const ShadowView& view);

  /// The share of the light that the filter lets through. Where a texel's ray passes a caster's edge by less than 2/256 of a
  /// texel, or depths are equal to what floats can tell, it may have either outcome.
  ShareRange share_at(const ShadowedPoint& point, const NearestCaster& nearest) const;

 private:
  /// One picture: parallel, or through a window at distance 1.
  struct Picture {
    glm::dvec3 eye;
    CameraBasis basis;
    glm::dvec2 upper_left, size;  // of the window; size.y is negative: down
    double near_distance, far_distance;
    bool is_parallel;
    double position_error;        // world units, LightView's

    glm::dvec3 seen(const glm::dvec3& point) const;  // right, up, and the distance along the line of sight
    double depth_at(double distance) const;          // 0 near .. 1 far
  };
  struct TexelPlace {
    const Picture* picture;
    glm::dvec2 texels;   // from the upper left corner
    double distance;     // along the line of sight
  };

  static Picture picture_of(const LightView& view);
  const Picture& picture_towards(const glm::dvec3& point) const;
  glm::dvec3 biased(const ShadowedPoint& point) const;
  ShareRange lit(const Picture& picture, const glm::dvec2& texel_middle, double reference_depth, const NearestCaster& nearest) const;
  ShareRange filtered(const TexelPlace& place, const NearestCaster& nearest) const;

  description::Shadow shadow_;
  std::vector<Picture> pictures_;  // one, or six faces
};

}  // namespace tuberia::witness
