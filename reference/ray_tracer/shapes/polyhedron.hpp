#pragma once
// Convex polyhedra.                                                                      [B 5.6] [C]

#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "reference/ray_tracer/shapes/shape.hpp"

namespace tuberia::tracer {

/// What half-spaces have in common: tin is the last way in, tout the first way out, and it is met if tin <= tout. Faces of
/// hits are the planes' numbers. Each face has the image of the side of the surrounding box that it looks like most, as on box_mesh.
class Polyhedron final : public Shape {
 public:
  static constexpr std::size_t kMostPlanes = 256;

  /// Of planes (n, d), n of any length but 0 and outwards: inside is n.p + d <= 0. Errors: numbers that are not finite, a normal of 0, planes
  /// that enclose nothing, an inside without end, more than kMostPlanes. They name the plane.
  static Result<std::shared_ptr<const Polyhedron>> create(std::span<const glm::dvec4> planes);

  std::optional<ShapeHit> intersect(const Ray& ray) const noexcept override;
  SurfacePoint surface(const Ray& ray, const ShapeHit& hit) const noexcept override;
  Box bounds() const noexcept override { return box_; }
  bool is_convex() const noexcept override { return true; }

 private:
  Polyhedron(std::vector<glm::dvec4> planes, const Box& box) noexcept : planes_(std::move(planes)), box_(box) {}

  std::vector<glm::dvec4> planes_;  // unit normals
  Box box_;
};

}  // namespace tuberia::tracer
