#pragma once
// Rays, and what they meet.                                                       [B 5.1] [A 2.1]

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace tuberia::tracer {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// r(t) = O + t D [B 5-1]. Things are met where t_min < t < t_max. D is unit in world space, so that t is a
/// distance there; where a transformation has changed its length, t still counts in D's.
struct Ray {
  glm::dvec3 origin{0, 0, 0}, direction{0, 0, -1};
  double t_min = 0, t_max = kInfinity;
  // A ray that goes on behind a surface meets others at the same place: at t_min itself items from this number on. Accelerators look.
  std::int64_t first_item_at_t_min = std::numeric_limits<std::int64_t>::max();

  glm::dvec3 at(double t) const noexcept { return origin + t * direction; }
};

/// Whether a ray can meet anything at all: everything but t_max is finite, the direction is not 0, and
/// t_min < t_max. Any other ray is a miss.
inline bool is_sound(const Ray& ray) noexcept {
  const auto is_finite = [](const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  return is_finite(ray.origin) && is_finite(ray.direction) && ray.direction != glm::dvec3(0) && std::isfinite(ray.t_min) && ray.t_min < ray.t_max;
}

/// What a ray meets of one shape. face and at are the shape's own way to remember where.
struct ShapeHit {
  double t = kInfinity;
  int face = 0;
  glm::dvec2 at{0, 0};
};

/// The nearest that a ray meets among numbered items; item is -1 if it is nothing.
struct Hit {
  double t = kInfinity;
  std::int64_t item = -1;
  int face = 0;
  glm::dvec2 at{0, 0};

  explicit operator bool() const noexcept { return item >= 0; }
  /// Nearer wins; of two at the same distance the item of the smaller number, so that the order of the
  /// questions does not matter.
  bool is_beaten_by(double other_t, std::int64_t other_item) const noexcept { return other_t < t || (other_t == t && other_item < item); }
  bool operator==(const Hit&) const = default;
};

/// A point of a surface, with what shading asks for. Normals are unit; they point outwards, whichever side the
/// ray came from.
struct SurfacePoint {
  glm::dvec3 position{0};
  glm::dvec3 geometric_normal{0, 0, 1};                 // of what the ray met
  glm::dvec3 normal{0, 0, 1};                           // of the surface that it stands for: interpolated on meshes, else the same
  glm::dvec3 tangent{1, 0, 0}, bitangent{0, -1, 0};     // dP/du, dP/dv, not unit; v runs down, as in images
  glm::dvec2 texcoord{0, 0};                            // (0, 0) is the upper left corner of the image
  glm::dvec3 colour{1, 1, 1};                           // of a mesh with colours at its vertices: times kd
  double magnitude = 0;                                 // the largest of the numbers that made the position, world units
};

/// How far to move a point along its geometric normal, world units, before rays start from it: far beyond the rounding of the
/// point and of the next intersection, both a few 2^-53 of the magnitude, and far below what a picture shows.
inline double safe_offset(const SurfacePoint& point) noexcept { return 1e-10 * point.magnitude; }

}  // namespace tuberia::tracer
