#pragma once
// Matrices and unit vectors, to the last bit as the documents write them.

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace tuberia::oracle {

/// The product, in double, rounded once to float.
glm::mat4 composed(const glm::mat4& a, const glm::mat4& b);

/// What normals are multiplied with where positions are multiplied with m.
glm::mat3 normal_matrix(const glm::mat4& m);

/// ((m0 x + m1 y) + m2 z) + m3 in float, with m a row of the matrix.
float row_times(const glm::mat4& m, int row, const glm::vec3& p);

/// (x x' + y y') + z z' in float.
float dot(const glm::vec3& a, const glm::vec3& b);

/// Float; the zero vector stays as it is.
glm::vec3 unit_vector(const glm::vec3& v);

/// A normal in the space that the matrix leads to, unit.
glm::vec3 transformed_normal(const glm::mat3& normal_matrix, const glm::vec3& normal);

}  // namespace tuberia::oracle
