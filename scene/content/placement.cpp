#include "scene/content/placement.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "math/transforms.hpp"

namespace tuberia {
namespace {

using Kind = description::Transform::Kind;

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

glm::dmat4 matrix_of(const description::Transform& step) {
  const glm::dmat4 identity(1);
  switch (step.kind) {
    case Kind::translate: return glm::translate(identity, step.vector);
    case Kind::rotate: return step.vector == glm::dvec3(0) ? identity : glm::rotate(identity, step.degrees * kRadiansPerDegree, step.vector);
    case Kind::scale: return glm::scale(identity, step.vector);
    case Kind::matrix: break;
  }
  return step.matrix;
}

}  // namespace

glm::dmat4 matrix_of(const std::vector<description::Transform>& steps) noexcept {
  glm::dmat4 world_from_object(1);
  for (const description::Transform& step : steps) world_from_object = matrix_of(step) * world_from_object;
  return world_from_object;
}

glm::mat4 float_matrix_of(const std::vector<description::Transform>& steps) noexcept {
  glm::mat4 world_from_object(1.0f);
  for (const description::Transform& step : steps) {
    const glm::mat4 next = step.kind == Kind::translate ? translation(step.vector)
                           : step.kind == Kind::rotate  ? rotation(step.vector, step.degrees * kRadiansPerDegree)
                           : step.kind == Kind::scale   ? scaling(step.vector)
                                                        : glm::mat4(step.matrix);
    world_from_object = compose(next, world_from_object);
  }
  return world_from_object;
}

}  // namespace tuberia
