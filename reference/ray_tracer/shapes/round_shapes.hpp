#pragma once
// Cylinders and cones about the y axis, centred at the origin, with or without caps.                         [B 5.6] [C]

#include "reference/ray_tracer/shapes/crossing.hpp"
#include "reference/ray_tracer/shapes/shape.hpp"

namespace tuberia::tracer {

/// What both share: faces 0 side, 1 upper cap, 2 lower cap. With caps they are solid bodies, and what is met is where the ray enters or
/// leaves the side's body and the layer between the caps; no ray passes between cap and side. Without, what is met of the side's body must
/// lie between the caps' heights. Radius and height have to be positive, or nothing meets them.
class RoundShape : public Shape {
 public:
  /// ends_in_tip: the side ends by itself at the upper height.
  RoundShape(double radius, double height, bool capped, bool ends_in_tip) noexcept
      : radius_(radius), half_(0.5 * height), capped_(capped), ends_in_tip_(ends_in_tip) {}
  std::optional<ShapeHit> intersect(const Ray& ray) const noexcept final;
  SurfacePoint surface(const Ray& ray, const ShapeHit& hit) const noexcept final;
  Box bounds() const noexcept final { return {{-radius_, -half_, -radius_}, {radius_, half_, radius_}}; }
  bool is_convex() const noexcept final { return true; }

 protected:
  /// Inside the body that has no end; nullopt if the line passes it.
  virtual std::optional<Crossing> cross_side(const Ray& ray) const noexcept = 0;
  virtual SurfacePoint side_surface(const glm::dvec3& near_surface) const noexcept = 0;

  double radius_, half_;  // half_: of the height

 private:
  bool capped_, ends_in_tip_;
};

/// As cylinder_mesh: u around the axis, v from the upper rim down. A tangent is a miss, as of a sphere.
class Cylinder final : public RoundShape {
 public:
  explicit Cylinder(double radius = 1, double height = 2, bool capped = true) noexcept : RoundShape(radius, height, capped, false) {}

 private:
  std::optional<Crossing> cross_side(const Ray& ray) const noexcept override;
  SurfacePoint side_surface(const glm::dvec3& near_surface) const noexcept override;
};

/// Its tip is up. As cone_mesh: u around the axis, v from the tip down; the tip itself has the u and the normal of the meridian through +x.
class Cone final : public RoundShape {
 public:
  explicit Cone(double radius = 1, double height = 2, bool capped = true) noexcept : RoundShape(radius, height, capped, true) {}

 private:
  std::optional<Crossing> cross_side(const Ray& ray) const noexcept override;
  SurfacePoint side_surface(const glm::dvec3& near_surface) const noexcept override;
};

}  // namespace tuberia::tracer
