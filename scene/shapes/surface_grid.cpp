#include "scene/shapes/surface_grid.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "math/parameter_error.hpp"

namespace tuberia {

void append_grid(Mesh& mesh, int columns, int rows, const std::function<SurfacePoint(int column, int row)>& point) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) {
      const SurfacePoint corner = point(column, row);
      mesh.positions.emplace_back(corner.position);
      mesh.normals.emplace_back(corner.normal);
      mesh.tangents.emplace_back(corner.tangent);
      mesh.bitangents.emplace_back(corner.bitangent);
      mesh.texcoords.emplace_back(corner.texcoord);
    }

  const auto add_triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto& at = mesh.positions;
    if (at[a] == at[b] || at[b] == at[c] || at[c] == at[a]) return;
    for (const std::uint32_t corner : {a, b, c}) mesh.indices.push_back(corner);
  };
  const auto stride = static_cast<std::uint32_t>(columns) + 1;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const std::uint32_t upper = first + static_cast<std::uint32_t>(row) * stride + static_cast<std::uint32_t>(column);
      const std::uint32_t lower = upper + stride;
      add_triangle(upper, lower, lower + 1);
      add_triangle(upper, lower + 1, upper + 1);
    }
}

glm::dvec2 point_on_unit_circle(int step, int steps) noexcept {
  // Only the first eighth of the turn is computed; the rest is its reflections. In units of 1/8 of a step.
  const std::int64_t turn = 8 * static_cast<std::int64_t>(steps);
  std::int64_t angle = 8 * static_cast<std::int64_t>(step) % turn;
  if (angle < 0) angle += turn;
  const std::int64_t quarter = turn / 4, quarters = angle / quarter;
  angle -= quarters * quarter;
  const bool beyond_diagonal = 2 * angle > quarter;
  if (beyond_diagonal) angle = quarter - angle;
  const double radians = 2.0 * std::numbers::pi * static_cast<double>(angle) / static_cast<double>(turn);

  glm::dvec2 point(std::cos(radians), std::sin(radians));
  if (2 * angle == quarter) point.x = point.y = std::numbers::sqrt2 / 2;
  if (beyond_diagonal) std::swap(point.x, point.y);
  for (std::int64_t i = 0; i < quarters; ++i) point = {0.0 - point.y, point.x};
  return point;
}

ShapeCheck& ShapeCheck::require(bool obeys, const char* name, double value, const char* rule) {
  if (!obeys && !error_) {
    error_ = parameter_error(name, value, rule);
    error_->message = std::string(shape_) + ": " + error_->message;
  }
  return *this;
}

ShapeCheck& ShapeCheck::positive(const char* name, double value) {
  return require(std::isfinite(value) && value > 0.0, name, value, "finite and greater than 0");
}

ShapeCheck& ShapeCheck::count(const char* name, int value, int smallest) {
  const std::string rule = "between " + std::to_string(smallest) + " and " + std::to_string(kMaxGridSide);
  return require(value >= smallest && value <= kMaxGridSide, name, value, rule.c_str());
}

ShapeCheck& ShapeCheck::product(const char* names, int first, int second) {
  const double product = static_cast<double>(first) * second;
  return require(product <= kMaxQuadrilaterals, names, product, "at most 16777216");
}

}  // namespace tuberia
