#include "reference/oracle/matrices.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tuberia::oracle {
namespace {

using Triple = std::array<double, 3>;

Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot_of(const Triple& a, const Triple& b) { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; }

}  // namespace

glm::mat4 composed(const glm::mat4& a, const glm::mat4& b) {
  glm::mat4 product;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) {
      double sum = static_cast<double>(a[0][row]) * static_cast<double>(b[column][0]);
      for (int k = 1; k < 4; ++k) sum += static_cast<double>(a[k][row]) * static_cast<double>(b[column][k]);
      product[column][row] = static_cast<float>(sum);
    }
  return product;
}

glm::mat3 normal_matrix(const glm::mat4& m) {
  const auto column = [&](int i) { return Triple{static_cast<double>(m[i][0]), static_cast<double>(m[i][1]), static_cast<double>(m[i][2])}; };
  const Triple x = column(0), y = column(1), z = column(2);
  const std::array<Triple, 3> cofactors{cross(y, z), cross(z, x), cross(x, y)};
  const double determinant = dot_of(x, cofactors[0]);
  const double volume = std::sqrt(dot_of(x, x)) * std::sqrt(dot_of(y, y)) * std::sqrt(dot_of(z, z));
  double divisor = determinant;
  if (!(std::abs(determinant) > 1e-12 * volume)) {
    divisor = 0;
    for (const Triple& c : cofactors)
      for (const double entry : c) divisor = std::max(divisor, std::abs(entry));
    if (divisor == 0) return glm::mat3(1);
  }
  glm::mat3 result;
  for (int i = 0; i < 3; ++i)
    for (int row = 0; row < 3; ++row)
      result[i][row] = static_cast<float>(cofactors[static_cast<std::size_t>(i)][static_cast<std::size_t>(row)] / divisor);
  return result;
}

float row_times(const glm::mat4& m, int row, const glm::vec3& p) {
  const float first = m[0][row] * p.x;
  const float second = m[1][row] * p.y;
  const float third = m[2][row] * p.z;
  return ((first + second) + third) + m[3][row];
}

float dot(const glm::vec3& a, const glm::vec3& b) {
  const float first = a.x * b.x;
  const float second = a.y * b.y;
  const float third = a.z * b.z;
  return (first + second) + third;
}

glm::vec3 unit_vector(const glm::vec3& v) {
  glm::vec3 u = v;
  const float squared = dot(v, v);
  if (!(squared > 1e-30f && squared < 1e30f)) {
    const float largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0)) return glm::vec3(0);
    const float lift = largest < 1e-20f ? 1e30f : 1.0f;
    for (int i = 0; i < 3; ++i) u[i] = (v[i] * lift) / (largest * lift);
  }
  const float inverse = 1.0f / std::sqrt(dot(u, u));
  return {u.x * inverse, u.y * inverse, u.z * inverse};
}

glm::vec3 transformed_normal(const glm::mat3& matrix, const glm::vec3& normal) {
  glm::vec3 n;
  for (int row = 0; row < 3; ++row) n[row] = dot({matrix[0][row], matrix[1][row], matrix[2][row]}, normal);
  return unit_vector(n);
}

}  // namespace tuberia::oracle
