#pragma once
// A ray's line as seen from the middle of a shape.

#include "reference/ray_tracer/ray.hpp"

namespace tuberia::tracer {

/// The points origin + s * direction, relative to a centre: the direction is unit, the origin the point nearest to the centre. However far the
/// ray starts and however long its direction is, the numbers are then of the size of the shape, and equations keep their digits.
struct CentredLine {
  explicit CentredLine(const Ray& ray, const glm::dvec3& centre = glm::dvec3(0)) noexcept
      : length(glm::length(ray.direction)), direction(ray.direction / length), offset(glm::dot(centre - ray.origin, direction)),
        origin((ray.origin - centre) + offset * direction) {}

  double t_of(double s) const noexcept { return (offset + s) / length; }
  glm::dvec3 at(double s) const noexcept { return origin + s * direction; }

  double length;
  glm::dvec3 direction;
  double offset;
  glm::dvec3 origin;
};

}  // namespace tuberia::tracer
