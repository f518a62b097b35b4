#pragma once
// Spheres.                                                             [B 5.6.1, 5-8..5-11, Figs 37-39]

#include "reference/ray_tracer/shapes/shape.hpp"

namespace tuberia::tracer {

/// A sphere without a positive, finite radius is met by nothing. A tangent counts as a miss, and a ray that starts exactly on the sphere
/// does not meet it there. Texture coordinates as of sphere_mesh: u around the y axis from +x over -z, v from +y down to -y.
class Sphere final : public Shape {
 public:
  explicit Sphere(double radius = 1, const glm::dvec3& centre = glm::dvec3(0)) noexcept : radius_(radius), centre_(centre) {}

  std::optional<ShapeHit> intersect(const Ray& ray) const noexcept override;
  SurfacePoint surface(const Ray& ray, const ShapeHit& hit) const noexcept override;
  Box bounds() const noexcept override { return {centre_ - radius_, centre_ + radius_}; }
  BoundingSphere bounding_sphere() const noexcept override { return {centre_, radius_}; }
  bool is_convex() const noexcept override { return true; }

 private:
  double radius_;
  glm::dvec3 centre_;
};

}  // namespace tuberia::tracer
