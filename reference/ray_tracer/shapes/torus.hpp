#pragma once
// Tori.

#include "reference/ray_tracer/shapes/centred_line.hpp"
#include "reference/ray_tracer/shapes/shape.hpp"

namespace tuberia::tracer {

/// A torus about the y axis around the origin. 0 < tube_radius < ring_radius, or nothing meets it. As torus_mesh: u around the
/// axis, v around the tube, from the inner equator over the top. A tangent is a miss.
class Torus final : public Shape {
 public:
  explicit Torus(double ring_radius = 1, double tube_radius = 0.4) noexcept : ring_(ring_radius), tube_(tube_radius) {}
  std::optional<ShapeHit> intersect(const Ray& ray) const noexcept override;
  SurfacePoint surface(const Ray& ray, const ShapeHit& hit) const noexcept override;
  Box bounds() const noexcept override { return {{-ring_ - tube_, -tube_, -ring_ - tube_}, {ring_ + tube_, tube_, ring_ + tube_}}; }

 private:
  double refined(const CentredLine& line, double s) const noexcept;

  double ring_, tube_;
};

}  // namespace tuberia::tracer
