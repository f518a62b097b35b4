#pragma once
// Surfaces of the second order.                                                          [B 5.6] [C]

#include <glm/mat4x4.hpp>
#include <memory>

#include "base/result.hpp"
#include "reference/ray_tracer/shapes/shape.hpp"

namespace tuberia::tracer {

/// The points p = (x, y, z, 1) with p'Qp = 0 inside a box, whose sides may be infinite: not closed where the box cuts it. Outside is where
/// p'Qp > 0. Where a ray touches the surface without crossing it is a miss. Texture coordinates: u around the vertical line through
/// the box's middle, from +x over -z; v from the box's top down to its bottom, or by the unit of length if it is infinite.
class Quadric final : public Shape {
 public:
  /// Errors: numbers that are not finite, a matrix that is 0 or not symmetric, a box whose lower side is above its upper one.
  static Result<std::shared_ptr<const Quadric>> create(const glm::dmat4& matrix, const glm::dvec3& lower, const glm::dvec3& upper);

  std::optional<ShapeHit> intersect(const Ray& ray) const noexcept override;
  SurfacePoint surface(const Ray& ray, const ShapeHit& hit) const noexcept override;
  Box bounds() const noexcept override { return box_; }
  /// If the inside is: the second derivatives are nowhere negative.
  bool is_convex() const noexcept override { return is_convex_; }

 private:
  Quadric(const glm::dmat4& matrix, const Box& box) noexcept;
  double value(const glm::dvec3& point) const noexcept;
  glm::dvec3 gradient(const glm::dvec3& point) const noexcept;
  void lay_image(SurfacePoint& point) const noexcept;

  glm::dmat4 matrix_;
  Box box_;
  glm::dvec3 centre_;   // of the box; 0 along an axis in which it is infinite
  double size_;         // the largest of the box's finite coordinates
  bool is_convex_;
};

}  // namespace tuberia::tracer
