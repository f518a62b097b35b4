#pragma once
// Triangles without gaps between neighbours.                                             [Woop]

#include <array>
#include <optional>

#include "reference/ray_tracer/items.hpp"

namespace tuberia::tracer {

/// a b - c d. Where rounding leaves 0 of it, what the rounding took is returned, so that the sign is always that of the exact value,
/// unless the products are below 1e-290. Exactly the negative of difference_of_products(c, d, a, b).
double difference_of_products(double a, double b, double c, double d) noexcept;

/// at: the weights of the second and the third corner; face: 0. The edges belong to both neighbours: whatever is rounded, a
/// ray through a closed net of triangles with equal corners meets at least one. Triangles seen edge on are missed.
std::optional<ShapeHit> intersect_triangle(const PreparedRay& ray, const std::array<glm::dvec3, 3>& corners) noexcept;

/// Whether the corners are finite and span an area, exactly.
bool has_area(const std::array<glm::dvec3, 3>& corners) noexcept;

}  // namespace tuberia::tracer
