#pragma once
// Where things are, as a person says it.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace tuberia::description {

/// One step of placing an object. A list of them is done in its order: the first one first.
struct Transform {
  enum class Kind : std::uint8_t { translate, rotate, scale, matrix };
  Kind kind = Kind::translate;
  glm::dvec3 vector{0};      // translate: by this; rotate: about this axis through the origin, not 0; scale: these factors
  double degrees = 0;        // rotate: counter-clockwise, seen against the axis
  glm::dmat4 matrix{1.0};    // matrix: the columns' last components are 0, 0, 0, 1
  bool operator==(const Transform&) const = default;
};

}  // namespace tuberia::description
