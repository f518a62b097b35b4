#pragma once
// Boxes as shapes.

#include "reference/ray_tracer/shapes/shape.hpp"

namespace tuberia::tracer {

/// A box around the origin along the axes. A size that is not positive: nothing meets it. Each face has the whole image,
/// as on box_mesh. Faces of hits: 2 * axis, + 1 on the negative side.
class Cuboid final : public Shape {
 public:
  explicit Cuboid(const glm::dvec3& size = glm::dvec3(2)) noexcept : half_(0.5 * size) {}
  std::optional<ShapeHit> intersect(const Ray& ray) const noexcept override;
  SurfacePoint surface(const Ray& ray, const ShapeHit& hit) const noexcept override;
  Box bounds() const noexcept override { return {-half_, half_}; }
  bool is_convex() const noexcept override { return true; }

 private:
  glm::dvec3 half_;
};

}  // namespace tuberia::tracer
