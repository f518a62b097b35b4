#include "scene/shapes/bezier_patches.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tuberia {
namespace {

// A cross product this small against the patch's size squared is rounding noise.
constexpr double kNoArea = 1e-12;

/// A parameter in [0, 1] and what it lacks to 1, so that an edge walked backwards gets the same bits.
struct Parameter {
  double t, rest;
};

/// The weights of four control points, and their derivatives.
struct Weights {
  std::array<double, 4> value, slope;
};

Weights weights(const Parameter& p) {
  const double t = p.t, r = p.rest;
  return {.value = {r * r * r, 3 * (r * r) * t, 3 * (t * t) * r, t * t * t},
          .slope = {-3 * (r * r), 3 * (r * r) - 6 * (t * r), 6 * (t * r) - 3 * (t * t), 3 * (t * t)}};
}

/// A weighted sum whose bits do not change when points and weights are taken in the reverse order.
glm::dvec3 blend(const std::array<double, 4>& weight, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                 const glm::dvec3& d) {
  return (weight[0] * a + weight[3] * d) + (weight[1] * b + weight[2] * c);
}

struct Derivatives {
  glm::dvec3 position, along_s, along_t, mixed;  // mixed: the second derivative by s and t
};

Derivatives derivatives(const BezierPatch& patch, const Parameter& s, const Parameter& t) {
  const Weights across = weights(s), down = weights(t);
  std::array<glm::dvec3, 4> row, row_slope;
  for (int i = 0; i < 4; ++i) {
    const auto along_row = [&](const std::array<double, 4>& weight) {
      return blend(weight, patch.point(i, 0), patch.point(i, 1), patch.point(i, 2), patch.point(i, 3));
    };
    row[static_cast<std::size_t>(i)] = along_row(across.value);
    row_slope[static_cast<std::size_t>(i)] = along_row(across.slope);
  }
  const auto [a, b, c, d] = row;
  const auto [slope_a, slope_b, slope_c, slope_d] = row_slope;
  return {.position = blend(down.value, a, b, c, d), .along_s = blend(down.value, slope_a, slope_b, slope_c, slope_d),
          .along_t = blend(down.slope, a, b, c, d), .mixed = blend(down.slope, slope_a, slope_b, slope_c, slope_d)};
}

double extent(const BezierPatch& patch) {
  double largest = 0;
  for (const glm::dvec3& point : patch.points) largest = std::max(largest, glm::length(point - patch.points[0]));
  return largest;
}

Parameter parameter(double t) { return {t, 1.0 - t}; }

/// t moved inwards by `step`.
double inwards(double t, double step) { return t + (0.5 - t) * 2.0 * step; }

glm::dvec3 normal_at(const BezierPatch& patch, const Derivatives& at, double s, double t) {
  const double size = extent(patch), no_area = kNoArea * size * size;
  glm::dvec3 area = glm::cross(at.along_t, at.along_s);
  if (glm::length(area) > no_area) return glm::normalize(area);

  // A little further in, the vanished derivative has grown by the mixed one: a whole edge in one point.
  const double in_s = s < 0.5 ? 1.0 : -1.0, in_t = t < 0.5 ? 1.0 : -1.0;
  if (glm::length(at.along_s) <= kNoArea * size) area = in_t * glm::cross(at.along_t, at.mixed);
  else if (glm::length(at.along_t) <= kNoArea * size) area = in_s * glm::cross(at.mixed, at.along_s);
  if (glm::length(area) > no_area) return glm::normalize(area);

  // Flatter still: the normal of a point further in.
  for (double step = 1e-4; step <= 1.0; step *= 4) {
    const Derivatives inside = derivatives(patch, parameter(inwards(s, step)), parameter(inwards(t, step)));
    area = glm::cross(inside.along_t, inside.along_s);
    if (glm::length(area) > no_area) return glm::normalize(area);
  }
  return {0, 1, 0};
}

SurfacePoint evaluate_at(const BezierPatch& patch, const Parameter& s, const Parameter& t) {
  const Derivatives at = derivatives(patch, s, t);
  const glm::dvec2 size = patch.texcoord_to - patch.texcoord_from;
  return {.position = at.position, .normal = normal_at(patch, at, s.t, t.t), .tangent = at.along_s / size.x,
          .bitangent = at.along_t / size.y, .texcoord = patch.texcoord_from + glm::dvec2(s.t, t.t) * size};
}

bool is_finite(const BezierPatch& patch) {
  return std::all_of(patch.points.begin(), patch.points.end(), [](const glm::dvec3& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
  });
}

}  // namespace

SurfacePoint evaluate(const BezierPatch& patch, double s, double t) {
  return evaluate_at(patch, parameter(s), parameter(t));
}

Result<Mesh> bezier_mesh(const BezierShape& shape) {
  if (shape.patches.empty()) return Error{"Bezier surface: there are no patches"};
  const auto patch_count = static_cast<int>(std::min<std::size_t>(shape.patches.size(), kMaxQuadrilaterals + 1));
  ShapeCheck check("Bezier surface");
  check.count("segments", shape.segments, 1).product("segments * segments", shape.segments, shape.segments);
  if (check.error()) return *check.error();
  check.product("patches * segments * segments", patch_count, shape.segments * shape.segments);
  if (check.error()) return *check.error();

  Mesh mesh;
  mesh.name = "Bezier surface";
  for (std::size_t number = 0; number < shape.patches.size(); ++number) {
    const BezierPatch& patch = shape.patches[number];
    const auto refuse = [&](const char* why) { return Error{"Bezier surface: patch " + std::to_string(number) + why}; };
    if (!is_finite(patch)) return refuse(" has a control point that is not finite");
    const glm::dvec2 size = patch.texcoord_to - patch.texcoord_from;
    if (!(std::isfinite(size.x * size.y) && size.x * size.y != 0)) return refuse(" has an empty rectangle of texture coordinates");
    const auto at = [&](int step) {
      return Parameter{static_cast<double>(step) / shape.segments, static_cast<double>(shape.segments - step) / shape.segments};
    };
    append_grid(mesh, shape.segments, shape.segments, [&](int column, int row) { return evaluate_at(patch, at(column), at(row)); });
  }
  return mesh;
}

}  // namespace tuberia
