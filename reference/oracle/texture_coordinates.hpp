#pragma once
// The texture coordinates of a unit, to the last bit.

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "reference/oracle/state.hpp"

namespace tuberia::oracle {

class UnitCoordinates {
 public:
  UnitCoordinates(const Draw&, std::size_t unit);

  /// (s, t, r, q) of a vertex: each from its source, then all times the matrix.
  glm::vec4 operator()(const InputVertex&) const;

 private:
  float generated(TexCoordSource, int coordinate, const InputVertex&) const;

  const Draw& draw_;
  std::size_t unit_;
  const TexCoordUnit& state_;
  glm::mat4 view_from_object_;
  glm::mat3 view_normal_from_object_;
};

}  // namespace tuberia::oracle
