#pragma once
// Shapes in the plane y = 0 that look to +y.                                        [B 5-12, 5-13]

#include "reference/ray_tracer/shapes/shape.hpp"

namespace tuberia::tracer {

/// All of the plane. Texture coordinates: x and z in units of length, so that images repeat.
class InfinitePlane final : public Shape {
 public:
  std::optional<ShapeHit> intersect(const Ray& ray) const noexcept override;
  SurfacePoint surface(const Ray& ray, const ShapeHit& hit) const noexcept override;
  Box bounds() const noexcept override { return {{-kInfinity, 0, -kInfinity}, {kInfinity, 0, kInfinity}}; }
  bool is_convex() const noexcept override { return true; }
};

/// Around the origin, width along x and depth along z; both have to be positive, or nothing meets it. As plane_mesh: u along x, v along z.
class Rectangle final : public Shape {
 public:
  explicit Rectangle(double width = 2, double depth = 2) noexcept : half_{0.5 * width, 0, 0.5 * depth} {}
  std::optional<ShapeHit> intersect(const Ray& ray) const noexcept override;
  SurfacePoint surface(const Ray& ray, const ShapeHit& hit) const noexcept override;
  Box bounds() const noexcept override { return {-half_, half_}; }
  bool is_convex() const noexcept override { return true; }

 private:
  glm::dvec3 half_;
};

/// Around the origin; the radius has to be positive, or nothing meets it. As disc_mesh: the image's square surrounds it.
class Disc final : public Shape {
 public:
  explicit Disc(double radius = 1) noexcept : radius_(radius) {}
  std::optional<ShapeHit> intersect(const Ray& ray) const noexcept override;
  SurfacePoint surface(const Ray& ray, const ShapeHit& hit) const noexcept override;
  Box bounds() const noexcept override { return {{-radius_, 0, -radius_}, {radius_, 0, radius_}}; }
  bool is_convex() const noexcept override { return true; }

 private:
  double radius_;
};

/// A disc across the y axis at a height, its front to +y or to -y: what caps are made of. The point's x and z are kept, its y is not.
SurfacePoint disc_surface(const glm::dvec3& point, double radius, double height, bool upwards) noexcept;

}  // namespace tuberia::tracer
