#pragma once
// Meshes moved, joined, and covered by an image several times.

#include <glm/ext/vector_double2.hpp>
#include <glm/mat4x4.hpp>

#include "base/result.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// The mesh in another space. Normals stay unit and outward, tangents stay derivatives; a matrix that mirrors turns the
/// triangles round, so that they stay counter-clockwise. The matrix must be affine.
Mesh transformed(Mesh mesh, const glm::mat4& to_from_object);

/// Both meshes as one, with the name and material of the first. Attributes that only one of them has are dropped.
Mesh joined(Mesh first, const Mesh& second);

/// The image repeated so many times along u and v (for Wrap::repeat): coordinates times `times`, tangents divided by it.
/// Error: a factor that is 0 or not finite; a negative one mirrors the image.
Result<Mesh> with_repeated_texture(Mesh mesh, const glm::dvec2& times);

}  // namespace tuberia
