#include "reference/oracle/texture_coordinates.hpp"

#include <cmath>

#include "reference/oracle/matrices.hpp"

namespace tuberia::oracle {
namespace {

/// ((a x + b y) + c z) + d in float.
float value_on(const glm::vec4& plane, const glm::vec3& p) {
  const float first = plane.x * p.x;
  const float second = plane.y * p.y;
  const float third = plane.z * p.z;
  return ((first + second) + third) + plane.w;
}

glm::vec3 reflected(const glm::vec3& u, const glm::vec3& n) {
  const float twice = 2 * dot(n, u);
  glm::vec3 r;
  for (int i = 0; i < 3; ++i) {
    const float along = n[i] * twice;
    r[i] = u[i] - along;
  }
  return r;
}

float on_sphere(const glm::vec3& r, int i) {
  const glm::vec3 lifted{r.x, r.y, r.z + 1};
  const float m = 2 * std::sqrt(dot(lifted, lifted));
  return m == 0 ? 0.5f : r[i] / m + 0.5f;
}

}  // namespace

UnitCoordinates::UnitCoordinates(const Draw& draw, std::size_t unit)
    : draw_(draw), unit_(unit), state_(draw.texcoord_units[unit]), view_from_object_(composed(draw.view_from_world, draw.world_from_object)),
      view_normal_from_object_(normal_matrix(view_from_object_)) {}

float UnitCoordinates::generated(TexCoordSource source, int i, const InputVertex& in) const {
  const glm::vec3 object(in.position);
  if (source == TexCoordSource::object_linear) return value_on(state_.plane[static_cast<std::size_t>(i)], object);
  glm::vec3 view;
  for (int row = 0; row < 3; ++row) view[row] = row_times(view_from_object_, row, object);
  if (source == TexCoordSource::eye_linear) return value_on(state_.plane[static_cast<std::size_t>(i)], view);
  const glm::vec3 normal = transformed_normal(view_normal_from_object_, in.normal);
  if (source == TexCoordSource::normal_map) return normal[i];
  const glm::vec3 reflection = reflected(unit_vector(view), normal);
  return source == TexCoordSource::sphere_map ? on_sphere(reflection, i) : reflection[i];
}

glm::vec4 UnitCoordinates::operator()(const InputVertex& in) const {
  const glm::vec4 own = draw_.has_unit_texcoords ? in.unit_texcoord[unit_] : glm::vec4(in.texcoord.x, in.texcoord.y, 0, 1);
  glm::vec4 made;
  for (int i = 0; i < 4; ++i) {
    const TexCoordSource source = state_.source[static_cast<std::size_t>(i)];
    made[i] = source == TexCoordSource::vertex ? own[i] : generated(source, i, in);
  }
  if (state_.matrix == glm::mat4(1)) return made;
  glm::vec4 moved;
  for (int row = 0; row < 4; ++row) {
    const glm::vec4 m{state_.matrix[0][row], state_.matrix[1][row], state_.matrix[2][row], state_.matrix[3][row]};
    const float first = m.x * made.x;
    const float second = m.y * made.y;
    const float third = m.z * made.z;
    const float fourth = m.w * made.w;
    moved[row] = ((first + second) + third) + fourth;
  }
  return moved;
}

}  // namespace tuberia::oracle
