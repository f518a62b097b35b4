#pragma once
// Light at a surface, in closed form and in double: mirrored and refracted directions, how much of the
// light goes each way, and how a rough surface spreads it.

#include <glm/vec3.hpp>
#include <optional>

namespace tuberia {

/// The vector at unit length, for any finite one but 0, however long or short; `fallback` for the zero
/// vector and for one that is not finite.                                               [rules S1]
glm::dvec3 normalized_or(const glm::dvec3& vector, const glm::dvec3& fallback) noexcept;

/// The direction that a mirror sends `incident` to, as long as it was: incident - 2 (n.incident) n for
/// the mirror's unit normal, on either side. A normal of another length is made unit; 0 mirrors nothing.
glm::dvec3 reflected(const glm::dvec3& incident, const glm::dvec3& normal) noexcept;

/// The unit direction in which light goes on behind a surface [Snell]: sin(in) n_from = sin(out) n_into.
/// incident: unit, arriving.   normal: unit, against the light.   n_from, n_into: refractive indices, > 0.
/// Nothing beyond the critical angle, where all of it is reflected.
std::optional<glm::dvec3> refracted(const glm::dvec3& incident, const glm::dvec3& normal, double n_from, double n_into) noexcept;

/// Shares of the light that a surface reflects, in [0, 1]; the rest goes through.
struct Reflectance {
  double perpendicular = 0, parallel = 0;  // of light that swings across the plane of incidence, and in it
  double mean() const noexcept { return 0.5 * (perpendicular + parallel); }  // of light that swings every way
};

/// Fresnel's equations between two clear materials.                                       [Fresnel]
/// cos_incidence: in [0, 1], between the light and the normal.   n_from, n_into: refractive indices, > 0.
/// Beyond the critical angle both are 1.
Reflectance fresnel(double cos_incidence, double n_from, double n_into) noexcept;

/// Beckmann's distribution of a rough surface's facets: exp(-(tan a / m)^2) / (pi m^2 cos^4 a), per
/// steradian; the integral of D cos a over the hemisphere is 1.                            [Beckmann]
/// cos_angle: of a, between a facet's normal and the surface's; 0 where it is not above 0.
/// roughness: m, the facets' root mean square slope, > 0.
double beckmann(double cos_angle, double roughness) noexcept;

}  // namespace tuberia
