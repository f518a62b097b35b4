#pragma once
// What parametric shapes share: points with derivatives, put together to a net of triangles.

#include <functional>
#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double3.hpp>
#include <optional>
#include <string_view>

#include "base/result.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// A point of a surface and its first derivatives, object space. A shape's texture coordinates run so that
/// the image appears upright and unmirrored from outside: u to the right, v down. Hence the outside normal is
/// along bitangent x tangent.
struct SurfacePoint {
  glm::dvec3 position{0, 0, 0}, normal{0, 0, 1};   // normal: unit, outward
  glm::dvec3 tangent{1, 0, 0}, bitangent{0, -1, 0};  // dP/du, dP/dv
  glm::dvec2 texcoord{0, 0};
};

/// Adds columns x rows quadrilaterals, both >= 1, two triangles each, counter-clockwise when the columns
/// run to the right and the rows down. point(column, row) is asked once for each corner, 0..columns and
/// 0..rows. Triangles with two corners at one position (at a pole) are left out.
void append_grid(Mesh& mesh, int columns, int rows, const std::function<SurfacePoint(int column, int row)>& point);

/// The cosine and the sine of step / steps of a full turn, any step, steps >= 1: exact at quarter
/// turns, and symmetric to the last bit about both axes and the diagonals.
glm::dvec2 point_on_unit_circle(int step, int steps) noexcept;

/// No side of a grid has more quadrilaterals, and no grid more than kMaxQuadrilaterals.
inline constexpr int kMaxGridSide = 16384;
inline constexpr int kMaxQuadrilaterals = 1 << 24;

/// Checks of parameters, in the order they are asked; the first complaint is kept.
class ShapeCheck {
 public:
  explicit ShapeCheck(std::string_view shape) : shape_(shape) {}
  /// value must be finite and greater than 0.
  ShapeCheck& positive(const char* name, double value);
  /// value must be between smallest and kMaxGridSide.
  ShapeCheck& count(const char* name, int value, int smallest);
  /// The product of two counts must be at most kMaxQuadrilaterals.
  ShapeCheck& product(const char* names, int first, int second);
  /// value must obey a rule of the shape's own.
  ShapeCheck& require(bool obeys, const char* name, double value, const char* rule);
  const std::optional<Error>& error() const noexcept { return error_; }

 private:
  std::string_view shape_;
  std::optional<Error> error_;
};

}  // namespace tuberia
