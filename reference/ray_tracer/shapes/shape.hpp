#pragma once
// What every shape can be asked.

#include <optional>

#include "reference/ray_tracer/box.hpp"
#include "reference/ray_tracer/ray.hpp"

namespace tuberia::tracer {

/// A surface in object space. Rays may have directions of any length but 0.
class Shape {
 public:
  virtual ~Shape() = default;

  /// The nearest hit with t_min < t < t_max. t does not depend on t_min and t_max, which only accept or
  /// refuse it. The ray is sound.
  virtual std::optional<ShapeHit> intersect(const Ray& ray) const noexcept = 0;

  /// The point that was hit, moved onto the surface as exactly as doubles allow; normals outwards.
  virtual SurfacePoint surface(const Ray& ray, const ShapeHit& hit) const noexcept = 0;

  /// Contains the whole shape; sides may be infinite.
  virtual Box bounds() const noexcept = 0;

  /// Contains the whole shape, if its box is finite.
  virtual BoundingSphere bounding_sphere() const noexcept { return sphere_around(bounds()); }

  /// Whether the line between any two points of its surface meets it nowhere else, so that the surface cannot shadow
  /// itself but where it is turned away.
  virtual bool is_convex() const noexcept { return false; }
};

}  // namespace tuberia::tracer
