#pragma once
// Plane polygons, concave and with holes.                              [B 5.6.2, 5-12, 5-13, Figs 40-42]

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "reference/ray_tracer/shapes/shape.hpp"

namespace tuberia::tracer {

/// A closed line of corners, seen from above its plane along one axis.
using Ring = std::vector<glm::dvec2>;

/// Jordan's curve theorem: the point is inside if a ray from it along +u crosses the rings an odd number of times. A corner on that ray counts as
/// on the +v side, so that each crossing counts once. Of two polygons that share an edge, exactly one has a point of it.
bool is_inside(std::span<const Ring> rings, const glm::dvec2& point) noexcept;

/// Its front is where the outline runs counter-clockwise; holes may run either way. The image covers the rectangle around the outline, as on the
/// side of a box that looks most like it.
class Polygon final : public Shape {
 public:
  /// Errors: an outline or hole of fewer than 3 corners, numbers that are not finite, an outline without an area, a corner that is
  /// farther from the plane than 1e-6 of the outline's size. They name the corner. Outlines should not cross themselves or
  /// each other; where they do, what is crossed an even number of times is outside.
  static Result<std::shared_ptr<const Polygon>> create(std::span<const glm::dvec3> outline, std::span<const std::vector<glm::dvec3>> holes = {});

  std::optional<ShapeHit> intersect(const Ray& ray) const noexcept override;
  SurfacePoint surface(const Ray& ray, const ShapeHit& hit) const noexcept override;
  Box bounds() const noexcept override { return box_; }
  bool is_convex() const noexcept override { return true; }

 private:
  Polygon(const glm::dvec3& corner, const glm::dvec3& normal) noexcept;
  void add_ring(std::span<const glm::dvec3> corners);
  glm::dvec2 projected(const glm::dvec3& point) const noexcept;
  glm::dvec3 on_plane(glm::dvec3 point) const noexcept;

  glm::dvec3 corner_, normal_;  // the first corner; unit
  int axis_;                    // the one that is dropped
  std::vector<Ring> rings_;
  Box box_;
};

}  // namespace tuberia::tracer
