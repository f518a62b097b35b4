#pragma once
// The things that accelerators find: numbered, each with a box and a test of its own.

#include <cstdint>

#include "reference/ray_tracer/box.hpp"
#include "reference/ray_tracer/ray.hpp"

namespace tuberia::tracer {

/// A ray with what all tests of it have in common.
struct PreparedRay {
  explicit PreparedRay(const Ray& sound_ray) noexcept;

  Ray ray;
  glm::dvec3 inverse_direction;  // infinite where a component is 0
  // Of watertight triangles: the axes so that z is where the direction is longest, and the shear that makes it z. [Woop]
  int x, y, z;
  glm::dvec3 shear;
};

class Items {
 public:
  virtual ~Items() = default;
  virtual std::int64_t count() const noexcept = 0;

  /// World space, contains the whole item; sides may be infinite. Nothing meets an item whose box is empty. The
  /// points that `intersect` finds are in the box, or outside by no more than 2^-42 of the largest coordinate around.
  virtual Box bounds(std::int64_t item) const noexcept = 0;

  /// Contains the whole item; a box's own unless an item knows a tighter one: its centroid and the farthest of its
  /// points [B 5.7.1]. Asked only of items whose box is finite.
  virtual BoundingSphere bounding_sphere(std::int64_t item) const noexcept;

  /// Replaces `nearest` if the item is met nearer, see Hit::is_beaten_by. Returns whether it did.
  virtual bool intersect(std::int64_t item, const PreparedRay& ray, Hit& nearest) const noexcept = 0;
};

}  // namespace tuberia::tracer
