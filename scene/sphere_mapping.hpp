#pragma once
// Texture coordinates as functions of position or normal.                        [B 4.1.1, 4-1 to 4-5]

#include <functional>
#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>

#include "base/result.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// The axes of a map on a sphere, unit and perpendicular to each other.
struct SphereAxes {
  glm::dvec3 pole{0, 1, 0};      // Tp, to the north pole
  glm::dvec3 equator{1, 0, 0};   // Te, to where u = 0 on the equator
  bool operator==(const SphereAxes&) const = default;
};

/// (u, v) of a unit normal in the notes' pattern space: v from 0 at the south pole to 1 at the north pole, u once around,
/// counter-clockwise seen from above the north pole, in [0, 1], and 0 at the poles [B 4-2 to 4-5, FIX 8].
glm::dvec2 sphere_coordinates(const glm::dvec3& normal, const SphereAxes& axes = {}) noexcept;

/// How an object's points find their place in a pattern: u = f, v = g [B 4-1], v UP as the notes have it.
struct TextureMapping {
  std::function<glm::dvec2(const glm::dvec3& position, const glm::dvec3& normal)> coordinates;  // object space
  bool u_wraps = false;    // u and u + 1 are one place: 0 beside 0.9 then means 1
  bool has_poles = false;  // at v = 0 and at v = 1, u has no meaning
};

/// sphere_coordinates of the normal; with use_positions of the direction from the origin, for objects that are not round.
/// Errors: an axis that is not finite or 0, axes that are parallel. Others are made unit and perpendicular, the pole being kept.
Result<TextureMapping> sphere_mapping(const SphereAxes& axes = {}, bool use_positions = false);

/// The mesh with texture coordinates (u, 1 - v) by a mapping; upright, since v runs down in images. Where u wraps, triangles across
/// the seam get coordinates beyond 1 and vertices of their own (sample them with Wrap::repeat); at poles a triangle's corner gets the mean u
/// of its other two. Tangents, which belonged to the old coordinates, are dropped: see with_tangents.
/// Errors: no normals; a coordinate that is not finite, naming the vertex.
Result<Mesh> with_texture_mapping(Mesh mesh, const TextureMapping& mapping);

}  // namespace tuberia
