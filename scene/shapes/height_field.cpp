#include "scene/shapes/height_field.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "scene/shapes/surface_grid.hpp"

namespace tuberia {
namespace {

double red(const Rgba8& texel) { return texel.r / 255.0; }
double red(const Rgba32F& texel) { return texel.r; }

/// The red of a picture at (u, v), linear between texel centres.
template <class Pixel>
double red_at(const Image<Pixel>& picture, double u, double v) {
  const auto place = [](double coordinate, int size) { return std::clamp(coordinate * size - 0.5, 0.0, size - 1.0); };
  const double x = place(u, picture.width()), y = place(v, picture.height());
  const int left = static_cast<int>(x), upper = static_cast<int>(y);
  const int right = std::min(left + 1, picture.width() - 1), lower = std::min(upper + 1, picture.height() - 1);
  const auto between = [&](int row) { return std::lerp(red(picture.at(left, row)), red(picture.at(right, row)), x - left); };
  return std::lerp(between(upper), between(lower), y - upper);
}

template <class Pixel>
Result<Mesh> mesh_of_picture(const HeightFieldShape& shape, const Image<Pixel>& picture, double tallest) {
  if (picture.empty()) return Error{"height field: the picture is empty"};
  ShapeCheck check("height field");
  check.require(std::isfinite(tallest), "tallest", tallest, "finite");
  if (check.error()) return *check.error();
  const double step_u = 1.0 / picture.width(), step_v = 1.0 / picture.height();
  return height_field_mesh(shape, [&](double u, double v) {
    const auto at = [&](double du, double dv) { return tallest * red_at(picture, u + du, v + dv); };
    return Height{.value = at(0, 0), .slope_u = (at(step_u, 0) - at(-step_u, 0)) / (2 * step_u),
                  .slope_v = (at(0, step_v) - at(0, -step_v)) / (2 * step_v)};
  });
}

}  // namespace

Result<Mesh> height_field_mesh(const HeightFieldShape& shape, const std::function<Height(double u, double v)>& height) {
  ShapeCheck check("height field");
  check.positive("width", shape.width).positive("depth", shape.depth).count("columns", shape.columns, 1);
  check.count("rows", shape.rows, 1).product("columns * rows", shape.columns, shape.rows);
  if (check.error()) return *check.error();

  Mesh mesh;
  mesh.name = "height field";
  append_grid(mesh, shape.columns, shape.rows, [&](int column, int row) {
    const double u = static_cast<double>(column) / shape.columns, v = static_cast<double>(row) / shape.rows;
    const Height at = height(u, v);
    check.require(std::isfinite(at.value) && std::isfinite(at.slope_u) && std::isfinite(at.slope_v), "a height", at.value,
                  "finite, and so must be its slopes");
    const glm::dvec3 tangent(shape.width, at.slope_u, 0), bitangent(0, at.slope_v, shape.depth);
    return SurfacePoint{.position = {(u - 0.5) * shape.width, at.value, (v - 0.5) * shape.depth},
                        .normal = glm::normalize(glm::cross(bitangent, tangent)), .tangent = tangent, .bitangent = bitangent,
                        .texcoord = {u, v}};
  });
  if (check.error()) return *check.error();
  return mesh;
}

Result<Mesh> height_field_mesh(const HeightFieldShape& shape, const Image<Rgba8>& picture, double tallest) {
  return mesh_of_picture(shape, picture, tallest);
}

Result<Mesh> height_field_mesh(const HeightFieldShape& shape, const Image<Rgba32F>& picture, double tallest) {
  return mesh_of_picture(shape, picture, tallest);
}

}  // namespace tuberia
