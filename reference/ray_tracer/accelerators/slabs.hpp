#pragma once
// Where a ray is inside a box: between the walls of all three slabs.                  [KayKajiya]

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "reference/ray_tracer/box.hpp"
#include "reference/ray_tracer/ray.hpp"

namespace tuberia::tracer {

/// Numbers beyond are not squared or multiplied: items that reach so far are asked by every ray.
inline constexpr double kLargestCoordinate = 1e100;

/// How far a computed point may be off, in world units: 2^-40 of the largest coordinate that went into it,
/// some thousand roundings.
inline double slack_of(double largest_coordinate) noexcept { return 0x1p-40 * largest_coordinate; }

inline double largest_component(const glm::dvec3& v) noexcept { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// A sound ray as boxes see it. Every box counts as larger by the slack, so that no hit of what it holds is lost to
/// rounding; and a box inside another is entered no earlier, to the last bit, since every step is monotonic.
class Slabs {
 public:
  /// largest_coordinate: of all the boxes that will be asked.
  Slabs(const Ray& ray, double largest_coordinate) noexcept
      : origin_(ray.origin), inverse_(inverse(ray.direction.x), inverse(ray.direction.y), inverse(ray.direction.z)),
        slack_(slack_of(std::max(largest_coordinate, largest_component(ray.origin))) * glm::abs(inverse_)), t_min_(ray.t_min) {}

  /// Where the ray comes to be in the box, at t_min or later, but at `limit` at the latest; infinity if nowhere.
  double entry(const Box& box, double limit) const noexcept {
    const glm::dvec3 lower = (box.lower - origin_) * inverse_, upper = (box.upper - origin_) * inverse_;
    const glm::dvec3 in = glm::min(lower, upper) - slack_, out = glm::max(lower, upper) + slack_;
    const double first = std::max(std::max(in.x, in.y), std::max(in.z, t_min_));
    const double last = std::min(std::min(out.x, out.y), std::min(out.z, limit));
    return first <= last ? first : kInfinity;
  }

 private:
  /// Finite where the direction is 0, too: there a ray is in a slab for ever or never, and 0 times infinity is neither.
  static double inverse(double direction) noexcept {
    constexpr double kMost = 1e150;
    return std::abs(direction) * kMost > 1 ? 1 / direction : std::copysign(kMost, direction);
  }

  glm::dvec3 origin_, inverse_, slack_;
  double t_min_;
};

}  // namespace tuberia::tracer
