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
      : inverse_(inverse(ray.direction.x), inverse(ray.direction.y), inverse(ray.direction.z)), t_min_(ray.t_min) {
    slack_ = slack_of(std::max(largest_coordinate, largest_component(ray.origin))) * glm::abs(inverse_);
    in_offset_ = ray.origin * inverse_ + slack_;
    out_offset_ = ray.origin * inverse_ - slack_;
  }

  /// Where the ray crosses the walls of a box on its way in and on its way out, the slack in it.
  struct Walls {
    glm::dvec3 in, out;
  };
  Walls walls(const Box& box) const noexcept {
    // What multiplying the coordinates before they are subtracted loses is far less than the slack.
    const auto first = [&](int axis) { return (inverse_[axis] < 0 ? box.upper : box.lower)[axis] * inverse_[axis] - in_offset_[axis]; };
    const auto last = [&](int axis) { return (inverse_[axis] < 0 ? box.lower : box.upper)[axis] * inverse_[axis] - out_offset_[axis]; };
    return {{first(0), first(1), first(2)}, {last(0), last(1), last(2)}};
  }
  /// How far from its true place `walls` has each, in units of t.
  const glm::dvec3& slack() const noexcept { return slack_; }

  /// Where the ray comes to be in the box, at t_min or later, but at `limit` at the latest; infinity if nowhere.
  double entry(const Walls& walls, double limit) const noexcept {
    const double first = std::max(std::max(walls.in.x, walls.in.y), std::max(walls.in.z, t_min_));
    const double last = std::min(std::min(walls.out.x, walls.out.y), std::min(walls.out.z, limit));
    return first <= last ? first : kInfinity;
  }
  double entry(const Box& box, double limit) const noexcept { return entry(walls(box), limit); }

 private:
  /// Finite where the direction is 0, too: there a ray is in a slab for ever or never, and 0 times infinity is neither.
  static double inverse(double direction) noexcept {
    constexpr double kMost = 1e150;
    return std::abs(direction) * kMost > 1 ? 1 / direction : std::copysign(kMost, direction);
  }

  glm::dvec3 inverse_, slack_, in_offset_, out_offset_;
  double t_min_;
};

}  // namespace tuberia::tracer
