#include "math/transforms.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "math/parameter_error.hpp"

namespace tuberia {

namespace {

// An angle below this between up and the line of sight leaves too few bits to find "right".
constexpr double kParallelSine = 1e-9;

// A determinant this small against its columns is rounding noise: its sign means nothing.
constexpr double kSingularDeterminant = 1e-12;

// The z in ndc of the near and of the far plane.
struct DepthEnds {
  double near_ndc, far_ndc;
};

DepthEnds depth_ends(ClipVolume volume, bool reversed) {
  DepthEnds ends{volume == ClipVolume::minus_w_to_w ? -1.0 : 0.0, 1.0};
  if (reversed) std::swap(ends.near_ndc, ends.far_ndc);
  return ends;
}

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::string text(const glm::dvec3& v) {
  char buffer[96];
  std::snprintf(buffer, sizeof buffer, "(%.9g, %.9g, %.9g)", v.x, v.y, v.z);
  return buffer;
}

// GLM's constructors take columns; the formulas are printed in rows.
glm::mat4 from_rows(const glm::dvec4& row0, const glm::dvec4& row1, const glm::dvec4& row2,
                    const glm::dvec4& row3) {
  return glm::mat4(glm::transpose(glm::dmat4(row0, row1, row2, row3)));
}

std::optional<Error> window_error(const ViewVolume& view) {
  if (!std::isfinite(view.left)) return parameter_error("left", view.left, "finite");
  if (!std::isfinite(view.bottom)) return parameter_error("bottom", view.bottom, "finite");
  if (!std::isfinite(view.right) || !(view.right > view.left))
    return parameter_error("right", view.right, "finite and greater than left");
  if (!std::isfinite(view.top) || !(view.top > view.bottom))
    return parameter_error("top", view.top, "finite and greater than bottom");
  return std::nullopt;
}

std::optional<Error> distance_error(double near_distance, double far_distance) {
  if (!std::isfinite(near_distance) || !(near_distance > 0.0))
    return parameter_error("near_distance", near_distance, "finite and greater than 0");
  if (!(far_distance > near_distance))
    return parameter_error("far_distance", far_distance, "greater than near_distance");
  return std::nullopt;
}

std::optional<Error> parallel_distance_error(const ViewVolume& view) {
  if (!std::isfinite(view.near_distance)) return parameter_error("near_distance", view.near_distance, "finite");
  if (!std::isfinite(view.far_distance) || !(view.far_distance > view.near_distance))
    return parameter_error("far_distance", view.far_distance, "finite and greater than near_distance");
  return std::nullopt;
}

}  // namespace

Result<CameraBasis> camera_basis(const glm::dvec3& eye, const glm::dvec3& point_of_interest,
                                 const glm::dvec3& up) {
  if (!is_finite(eye)) return Error{"eye " + text(eye) + " is not finite"};
  if (!is_finite(point_of_interest))
    return Error{"point_of_interest " + text(point_of_interest) + " is not finite"};
  if (!is_finite(up)) return Error{"up " + text(up) + " is not finite"};

  const glm::dvec3 backwards = eye - point_of_interest;
  const double distance = glm::length(backwards), up_length = glm::length(up);
  if (!(distance > 0.0)) return Error{"eye and point_of_interest are both " + text(eye)};
  if (!(up_length > 0.0)) return Error{"up " + text(up) + " has no direction"};

  const glm::dvec3 w = backwards / distance;
  const glm::dvec3 right = glm::cross(up / up_length, w);
  const double sine = glm::length(right);
  if (!(sine > kParallelSine)) return Error{"up " + text(up) + " is parallel to the line of sight"};
  const glm::dvec3 u = right / sine;
  return CameraBasis{.u = u, .v = glm::cross(w, u), .w = w};
}

glm::mat4 view_from_world(const CameraBasis& basis, const glm::dvec3& eye) noexcept {
  return from_rows({basis.u, -glm::dot(basis.u, eye)}, {basis.v, -glm::dot(basis.v, eye)},
                   {basis.w, -glm::dot(basis.w, eye)}, {0, 0, 0, 1});
}

Result<ViewVolume> perspective_volume(double fovy_radians, double aspect, double near_distance,
                                      double far_distance) {
  if (!(fovy_radians > 0.0 && fovy_radians < std::numbers::pi))
    return parameter_error("fovy_radians", fovy_radians, "greater than 0 and less than pi");
  if (!std::isfinite(aspect) || !(aspect > 0.0))
    return parameter_error("aspect", aspect, "finite and greater than 0");
  if (const auto error = distance_error(near_distance, far_distance)) return *error;

  const double top = near_distance * std::tan(0.5 * fovy_radians), right = aspect * top;
  return ViewVolume{.left = -right, .right = right, .bottom = -top, .top = top,
                    .near_distance = near_distance, .far_distance = far_distance};
}

Result<ViewVolume> orthographic_volume(double width, double height, double near_distance, double far_distance) {
  if (!std::isfinite(width) || !(width > 0.0)) return parameter_error("width", width, "finite and greater than 0");
  if (!std::isfinite(height) || !(height > 0.0)) return parameter_error("height", height, "finite and greater than 0");
  const ViewVolume view{.left = -0.5 * width, .right = 0.5 * width, .bottom = -0.5 * height, .top = 0.5 * height,
                        .near_distance = near_distance, .far_distance = far_distance};
  if (const auto error = parallel_distance_error(view)) return *error;
  return view;
}

Result<glm::mat4> orthographic(const ViewVolume& view, ClipVolume clip_volume, bool reversed_depth) {
  if (const auto error = window_error(view)) return *error;
  if (const auto error = parallel_distance_error(view)) return *error;
  const double near_distance = view.near_distance, far_distance = view.far_distance;

  // z_ndc is linear in the distance -z, with the given values at the two planes.
  const auto [near_ndc, far_ndc] = depth_ends(clip_volume, reversed_depth);
  const double width = view.right - view.left, height = view.top - view.bottom;
  const double depth = far_distance - near_distance;
  const double z_scale = (near_ndc - far_ndc) / depth;
  const double z_offset = (near_ndc * far_distance - far_ndc * near_distance) / depth;
  return from_rows({2.0 / width, 0, 0, -(view.right + view.left) / width},
                   {0, 2.0 / height, 0, -(view.top + view.bottom) / height},
                   {0, 0, z_scale, z_offset}, {0, 0, 0, 1});
}

Result<glm::mat4> frustum(const ViewVolume& view, ClipVolume clip_volume, bool reversed_depth) {
  if (const auto error = window_error(view)) return *error;
  const double near_distance = view.near_distance, far_distance = view.far_distance;
  if (const auto error = distance_error(near_distance, far_distance)) return *error;

  // z_ndc = -z_scale + z_offset / distance must give the ends' values at the two planes. Divided
  // by the far distance, the solution stays finite when that is infinite.
  const auto [near_ndc, far_ndc] = depth_ends(clip_volume, reversed_depth);
  const double near_over_far = near_distance / far_distance;
  const double z_scale = (near_ndc * near_over_far - far_ndc) / (1.0 - near_over_far);
  const double z_offset = (near_ndc - far_ndc) * near_distance / (1.0 - near_over_far);
  const double width = view.right - view.left, height = view.top - view.bottom;
  return from_rows({2.0 * near_distance / width, 0, (view.right + view.left) / width, 0},
                   {0, 2.0 * near_distance / height, (view.top + view.bottom) / height, 0},
                   {0, 0, z_scale, z_offset}, {0, 0, -1, 0});
}

Result<glm::mat4> perspective(double fovy_radians, double aspect, double near_distance, double far_distance,
                              ClipVolume clip_volume, bool reversed_depth) {
  const auto view = perspective_volume(fovy_radians, aspect, near_distance, far_distance);
  if (!view) return view.error();
  return frustum(*view, clip_volume, reversed_depth);
}

glm::mat4 translation(const glm::dvec3& offset) noexcept {
  return from_rows({1, 0, 0, offset.x}, {0, 1, 0, offset.y}, {0, 0, 1, offset.z}, {0, 0, 0, 1});
}

glm::mat4 scaling(const glm::dvec3& factors) noexcept {
  return from_rows({factors.x, 0, 0, 0}, {0, factors.y, 0, 0}, {0, 0, factors.z, 0}, {0, 0, 0, 1});
}

glm::mat4 rotation(const glm::dvec3& axis, double angle_radians) noexcept {
  const double length = glm::length(axis);
  if (!(length > 0.0)) return glm::mat4(1.0f);

  // Rodrigues: v cos + (axis x v) sin + axis (axis . v) (1 - cos), applied to the three unit vectors.
  const glm::dvec3 unit = axis / length;
  const double cosine = std::cos(angle_radians), sine = std::sin(angle_radians);
  glm::dmat4 result(1.0);
  for (int column = 0; column < 3; ++column) {
    glm::dvec3 source(0.0);
    source[column] = 1.0;
    const glm::dvec3 turned =
        source * cosine + glm::cross(unit, source) * sine + unit * (unit[column] * (1.0 - cosine));
    result[column] = glm::dvec4(turned, 0.0);
  }
  return glm::mat4(result);
}

glm::mat4 mirror(const glm::dvec3& normal, double distance) noexcept {
  const double squared = glm::dot(normal, normal);
  if (!(squared > 0.0)) return glm::mat4(1.0f);
  // Each point moves by twice its distance, along the normal: p - 2 (n.p - d) / (n.n) n.
  glm::dmat4 result(1.0);
  for (int column = 0; column < 3; ++column)
    result[column] -= glm::dvec4(normal * (2.0 * normal[column] / squared), 0.0);
  result[3] += glm::dvec4(normal * (2.0 * distance / squared), 0.0);
  return glm::mat4(result);
}

glm::mat4 compose(const glm::mat4& to_from_middle, const glm::mat4& middle_from_source) noexcept {
  return glm::mat4(glm::dmat4(to_from_middle) * glm::dmat4(middle_from_source));
}

glm::mat3 normal_matrix(const glm::mat4& world_from_object) noexcept {
  // The cofactors are the cross products of the columns; divided by the determinant they are the
  // inverse transpose.
  const glm::dvec3 x(world_from_object[0]), y(world_from_object[1]), z(world_from_object[2]);
  const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  const double determinant = glm::dot(x, cofactors[0]);
  const double volume_bound = glm::length(x) * glm::length(y) * glm::length(z);

  double divisor = determinant;
  if (!(std::abs(determinant) > kSingularDeterminant * volume_bound)) {
    divisor = 0.0;
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 3; ++row) divisor = std::max(divisor, std::abs(cofactors[column][row]));
    if (!(divisor > 0.0)) return glm::mat3(1.0f);
  }
  return glm::mat3(cofactors / divisor);
}

}  // namespace tuberia
