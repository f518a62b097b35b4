// Setting up a FilterRay. Compiled once per instruction set.

#if defined(TUBERIA_RAY_TRACER_FILTER_RAY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RAY_TRACER_FILTER_RAY_INL
#undef TUBERIA_RAY_TRACER_FILTER_RAY_INL
#else
#define TUBERIA_RAY_TRACER_FILTER_RAY_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

#include "reference/ray_tracer/fast/fast_triangles.hpp"
#include "reference/ray_tracer/fast/filter_ray.hpp"
#include "reference/ray_tracer/fast/wide_tree.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia::tracer {
namespace HWY_NAMESPACE {

// A float's rounding is at most this part of it.
inline constexpr float kUnit = 0x1p-24f;

// Further away, in sizes of the scene, an origin is moved.
inline constexpr float kFar = 16;
// Further away even doubles do not tell one point of the scene from another.
inline constexpr double kTooFar = 0x1p40;
// Directions within are used as they are: no product of theirs leaves the floats' range.
inline constexpr float kShortest = 0x1p-20f, kLongest = 0x1p20f;
// Of reciprocals, so that those of zeros are finite. A direction's component that is smaller moves nothing by an error's size.
inline constexpr float kLargestInverse = 0x1p100f;

// More than all that is lost where products are too small for floats.
inline constexpr float kUnderflow = 1e-36f;

HWY_INLINE float largest_of(const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// The distance of the furthest corner along any axis.
HWY_INLINE float reach(const Bounds& bounds, const glm::vec3& from) {
  float furthest = 0;
  for (int axis = 0; axis < 3; ++axis)
    furthest = std::max(furthest, std::max(bounds.upper[axis] - from[axis], from[axis] - bounds.lower[axis]));
  return furthest;
}

/// Whether all numbers but t_max are finite, the direction is not 0 and t_min < t_max.
HWY_INLINE bool is_sound(const FastRay& ray) {
  // 0 times anything finite is 0.
  const glm::vec3 zeros = 0.0f * ray.origin + 0.0f * ray.direction;
  return zeros.x + zeros.y + zeros.z + 0.0f * ray.t_min == 0 && ray.t_min < ray.t_max && ray.direction != glm::vec3(0);
}

HWY_INLINE int longest_axis(const glm::vec3& v) {
  const glm::vec3 size(std::abs(v.x), std::abs(v.y), std::abs(v.z));
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

HWY_INLINE void set_up(FilterRay& filter, const Bounds& bounds, const glm::vec3& origin, const glm::vec3& direction, float misplaced) {
  filter.origin = origin, filter.direction = direction;
  filter.furthest = reach(bounds, origin), filter.misplaced = misplaced;
  // A plane's distance is subtracted and multiplied by a reciprocal, each rounded once; and so is `enter` itself.
  const float roundings = 4 * kUnit * filter.furthest + 2 * misplaced;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_negative = std::signbit(direction[axis]);
    const float outwards = std::copysign(roundings + 2 * kUnit * std::abs(origin[axis]), direction[axis]);
    filter.enter[axis] = origin[axis] + outwards;
    filter.leave[axis] = origin[axis] - outwards;
    const float inverse = std::abs(direction[axis]) > 1 / kLargestInverse ? 1 / direction[axis] : std::copysign(kLargestInverse, direction[axis]);
    filter.minus_inverse[axis] = -inverse;
    const auto lower = static_cast<std::size_t>(axis) * kWidth, upper = lower + 3 * kWidth;
    filter.near_plane[axis] = is_negative ? upper : lower;
    filter.far_plane[axis] = is_negative ? lower : upper;
  }
}

HWY_INLINE ShearedRay sheared(const FilterRay& filter) {
  ShearedRay ray;
  const int z = longest_axis(filter.direction), x = z == 2 ? 0 : z + 1, y = x == 2 ? 0 : x + 1;
  ray.axis[0] = x, ray.axis[1] = y, ray.axis[2] = z;
  for (int i = 0; i < 3; ++i) ray.origin[i] = filter.origin[ray.axis[i]];
  ray.inverse_z = 1 / filter.direction[z];
  ray.shear_x = filter.direction[x] * ray.inverse_z;
  ray.shear_y = filter.direction[y] * ray.inverse_z;
  // A corner is off by one rounding each of x and z, two of the shear, one of the product, two of a difference that may be twice as
  // large. An area is off by four corners' errors times coordinates, which are below twice the triangle's size where it is met,
  // and three roundings of its own.
  const float corner_error = 8 * kUnit * filter.furthest + 4 * filter.misplaced;
  ray.area_error_of_size = 12 * corner_error;
  ray.area_error = 12 * corner_error * corner_error + kUnderflow;
  return ray;
}

// Scaled, moved or both. Whether the ray passes near the triangles at all.
HWY_NOINLINE bool set_up_unusual(FilterRay& filter, const Bounds& bounds, const FastRay& ray) {
  int exponent = 0;
  std::frexp(largest_of(ray.direction), &exponent);
  const glm::dvec3 direction = glm::dvec3(ray.direction) * std::ldexp(1.0, -exponent);
  const glm::dvec3 origin(ray.origin), centre = 0.5 * glm::dvec3(bounds.lower) + 0.5 * glm::dvec3(bounds.upper);
  const double size = largest_of(bounds.upper - bounds.lower);
  filter.t_scale = std::ldexp(1.0, exponent);

  glm::vec3 near_origin = ray.origin;
  float misplaced = 0;
  if (reach(bounds, ray.origin) > kFar * static_cast<float>(size)) {
    const double offset = glm::dot(centre - origin, direction) / glm::dot(direction, direction);
    const glm::dvec3 nearest = origin + offset * direction;
    const double distance = glm::length(origin - centre);
    if (glm::length(nearest - centre) > 2 * size || distance > kTooFar * size) return false;
    near_origin = glm::vec3(nearest);
    misplaced = kUnit * largest_of(near_origin) + static_cast<float>(0x1p-48 * distance);
    filter.t_offset = offset / filter.t_scale;
    filter.t_error = 4 * misplaced;
  }
  set_up(filter, bounds, near_origin, glm::vec3(direction), misplaced);
  return true;
}

/// Whether the ray can meet anything.
HWY_INLINE bool set_up(FilterRay& filter, const WideTree& tree, const FastRay& ray) {
  if (!is_sound(ray)) return false;
  const float longest = largest_of(ray.direction);
  if (longest > kShortest && longest < kLongest && reach(tree.bounds, ray.origin) < kFar * largest_of(tree.bounds.upper - tree.bounds.lower)) {
    set_up(filter, tree.bounds, ray.origin, ray.direction, 0);
    filter.t_offset = 0, filter.t_scale = 1, filter.t_error = 0;
  } else if (!set_up_unusual(filter, tree.bounds, ray)) {
    return false;
  }
  filter.t_min = filter.earliest(ray.t_min);
  filter.t_max = filter.latest(ray.t_max);
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia::tracer
HWY_AFTER_NAMESPACE();

#endif
