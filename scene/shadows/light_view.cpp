#include "scene/shadows/light_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "scene/environment/render_cube.hpp"

namespace tuberia {
namespace {

// Room around what the light must see, so that neither rounding nor a filter cuts its edges off.
constexpr double kWindowSlack = 1.0 / 128, kPlaneSlack = 1e-3;

// The near plane's smallest distance, in far planes: nearer, a float's depths get too coarse at the far end.
constexpr double kNearestPlane = 1e-3;

// Wider spots (80 degrees from their axis) are seen as points are: a plane stretches what is far from its middle.
constexpr float kLeastSpotCosine = 0.17f;

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Some direction across the line of sight.
glm::dvec3 up_for(const glm::dvec3& line_of_sight) {
  return std::abs(line_of_sight.y) > 0.99 * glm::length(line_of_sight) ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
}

std::array<glm::dvec3, 8> corners_of(const Bounds& box) {
  std::array<glm::dvec3, 8> corners;
  for (unsigned i = 0; i < 8; ++i) corners[i] = {i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y, i & 4 ? box.upper.z : box.lower.z};
  return corners;
}

/// The middle of the narrowest cone around all corners, or nearly: of the smallest ball around their
/// directions, by steps to the farthest one that get shorter and shorter [Badoiu]. Zero if there is none.
glm::dvec3 middle_direction(const Bounds& box, const glm::dvec3& eye) {
  std::array<glm::dvec3, 8> directions = corners_of(box);
  for (glm::dvec3& direction : directions) {
    direction -= eye;
    if (!(glm::length(direction) > 0)) return glm::dvec3(0);
    direction = glm::normalize(direction);
  }
  const auto nearer = [](const glm::dvec3& from) {
    return [from](const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - from) < glm::length(b - from); };
  };
  glm::dvec3 middle = directions[0];
  for (int step = 2; step < 200; ++step) middle += (*std::max_element(directions.begin(), directions.end(), nearer(middle)) - middle) / static_cast<double>(step);
  return middle;
}

/// Extents along the axes of a view; distances along -z.
struct ViewExtent {
  glm::dvec3 smallest{std::numeric_limits<double>::infinity()}, largest{-std::numeric_limits<double>::infinity()};
};

/// Of a box's corners; in_window makes of a view-space point what is compared of it.
template <class InWindow>
ViewExtent extent_of(const Bounds& box, const CameraBasis& basis, const glm::dvec3& eye, const InWindow& in_window) {
  ViewExtent extent;
  for (const glm::dvec3& corner : corners_of(box)) {
    const glm::dvec3 offset = corner - eye;
    const glm::dvec3 q = in_window(glm::dvec3(glm::dot(offset, basis.u), glm::dot(offset, basis.v), -glm::dot(offset, basis.w)));
    extent.smallest = glm::min(extent.smallest, q);
    extent.largest = glm::max(extent.largest, q);
  }
  return extent;
}

ViewVolume window_around(const ViewExtent& extent, double slack) {
  return {.left = extent.smallest.x - slack, .right = extent.largest.x + slack, .bottom = extent.smallest.y - slack, .top = extent.largest.y + slack};
}

/// The window on the plane at distance 1 through which an eye sees a box that is wholly before it.
ViewVolume window_at_one(const Bounds& box, const CameraBasis& basis, const glm::dvec3& eye) {
  const ViewExtent extent = extent_of(box, basis, eye, [](const glm::dvec3& p) { return glm::dvec3(p.x / p.z, p.y / p.z, p.z); });
  const glm::dvec3 size = extent.largest - extent.smallest;
  return window_around(extent, std::max({size.x, size.y, kPlaneSlack}) * kWindowSlack);
}

ViewVolume window_at(const ViewVolume& at_one, double near_distance, double far_distance) {
  return {.left = at_one.left * near_distance, .right = at_one.right * near_distance, .bottom = at_one.bottom * near_distance,
          .top = at_one.top * near_distance, .near_distance = near_distance, .far_distance = far_distance};
}

Result<Camera> directional_camera(const glm::dvec3& towards, const Bounds& seen) {
  if (!(glm::length(towards) > 0)) return Error{"the light's direction is zero"};
  const glm::dvec3 eye(seen.centre());
  Camera camera{.eye = eye, .point_of_interest = eye - towards, .up = up_for(towards), .projection = Projection::orthographic};
  const auto basis = basis_of(camera);
  if (!basis) return basis.error();
  const ViewExtent extent = extent_of(seen, *basis, eye, [](const glm::dvec3& p) { return p; });
  // A box that is a point still gets a window.
  const double radius = seen.radius() > 0 ? static_cast<double>(seen.radius()) : 1.0;
  camera.view = window_around(extent, radius * kWindowSlack);
  camera.view.near_distance = extent.smallest.z - radius * kPlaneSlack;
  camera.view.far_distance = extent.largest.z + radius * kPlaneSlack;
  return camera;
}

Result<Camera> positional_camera(const glm::dvec3& position, const Bounds& seen) {
  const Error inside{"the light lies inside of what it is to see, or too close to it for one picture"};
  const glm::dvec3 middle = middle_direction(seen, position);
  Camera camera{.eye = position, .point_of_interest = position + middle, .up = up_for(middle)};
  const auto basis = basis_of(camera);
  if (!basis) return inside;
  const ViewExtent distances = extent_of(seen, *basis, position, [](const glm::dvec3& p) { return p; });
  if (!(distances.smallest.z > kNearestPlane * distances.largest.z)) return inside;
  camera.view = window_at(window_at_one(seen, *basis, position), distances.smallest.z * (1 - kPlaneSlack), distances.largest.z * (1 + kPlaneSlack));
  return camera;
}

/// Along the axis, as wide as the cone or as the box if that is narrower.
Result<Camera> spot_camera(const Light& spot, const Bounds& seen) {
  const glm::dvec3 position(spot.towards), axis(spot.axis);
  if (!(glm::length(axis) > 0)) return Error{"the spot's axis is zero"};
  Camera camera{.eye = position, .point_of_interest = position + axis, .up = up_for(axis)};
  const auto basis = basis_of(camera);
  if (!basis) return basis.error();
  const ViewExtent distances = extent_of(seen, *basis, position, [](const glm::dvec3& p) { return p; });
  if (!(distances.largest.z > 0)) return Error{"what the spot is to see lies behind it"};

  const double far_distance = distances.largest.z * (1 + kPlaneSlack);
  const double near_distance = std::max(distances.smallest.z * (1 - kPlaneSlack), far_distance * kNearestPlane);
  const auto cosine = static_cast<double>(spot.cos_outer);
  const double tangent = std::sqrt(1 - cosine * cosine) / cosine * (1 + 2 * kWindowSlack);
  ViewVolume at_one{.left = -tangent, .right = tangent, .bottom = -tangent, .top = tangent};
  if (distances.smallest.z > kNearestPlane * distances.largest.z) {
    const ViewVolume box = window_at_one(seen, *basis, position);
    at_one = {.left = std::max(at_one.left, box.left), .right = std::min(at_one.right, box.right), .bottom = std::max(at_one.bottom, box.bottom), .top = std::min(at_one.top, box.top)};
    if (!(at_one.left < at_one.right && at_one.bottom < at_one.top)) return Error{"what the spot is to see lies outside of its cone"};
  }
  camera.view = window_at(at_one, near_distance, far_distance);
  return camera;
}

/// What no light can see.
std::optional<Error> check(const Light& light, const Bounds& seen) {
  if (seen.empty()) return Error{"the box that the light is to see is empty"};
  if (!is_finite(seen.lower) || !is_finite(seen.upper)) return Error{"the box that the light is to see is not finite"};
  if (!is_finite(light.towards)) return Error{"the light's direction or position is not finite"};
  if (light.kind == Light::Kind::spot && !is_finite(light.axis)) return Error{"the spot's axis is not finite"};
  return {};
}

/// From clip space to (s, t, depth) times w.
glm::mat4 map_from_clip(ClipVolume volume) {
  const bool is_signed = volume == ClipVolume::minus_w_to_w;
  glm::mat4 m(0);
  m[0].x = 0.5f;
  m[1].y = -0.5f;
  m[2].z = is_signed ? 0.5f : 1.0f;
  m[3] = {0.5f, 0.5f, is_signed ? 0.5f : 0.0f, 1};
  return m;
}

}  // namespace

Result<LightView> light_view(const Camera& camera) {
  if (camera.reversed_depth) return Error{"a light's view with reversed depth cannot be compared with"};
  const auto matrices = camera_matrices(camera);
  if (!matrices) return matrices.error();
  const auto basis = basis_of(camera);
  if (!basis) return basis.error();

  const ViewVolume& view = camera.view;
  const double window_distance = camera.projection == Projection::perspective ? view.near_distance : 1.0;
  const double extent = glm::length(camera.eye) + std::max(std::abs(view.near_distance), std::abs(view.far_distance));
  return LightView{.camera = camera,
                   .clip_from_world = matrices->clip_from_world,
                   .map_from_world = compose(map_from_clip(camera.clip_volume), matrices->clip_from_world),
                   .right = glm::vec3(basis->u * ((view.right - view.left) / window_distance)),
                   .down = glm::vec3(basis->v * ((view.bottom - view.top) / window_distance)),
                   .position_error = static_cast<float>(extent * 0x1p-22)};
}

Result<Camera> light_camera(const Light& light, const Bounds& seen) {
  if (auto error = check(light, seen)) return *std::move(error);
  const bool is_narrow = light.kind == Light::Kind::spot && light.cos_outer >= kLeastSpotCosine;
  auto camera = is_narrow ? spot_camera(light, seen)
                : light.kind == Light::Kind::directional ? directional_camera(light.towards, seen) : positional_camera(light.towards, seen);
  if (camera) camera->clip_volume = ClipVolume::zero_to_w;
  return camera;
}

Result<LightView> light_view(const Light& light, const Bounds& seen) {
  const auto camera = light_camera(light, seen);
  if (!camera) return camera.error();
  return light_view(*camera);
}

Result<LightCube> light_cube(const Light& light, const Bounds& seen) {
  if (auto error = check(light, seen)) return *std::move(error);
  if (light.kind == Light::Kind::directional) return Error{"a directional light does not shine all around"};
  const glm::dvec3 position(light.towards);
  const glm::dvec3 farthest = glm::max(glm::abs(glm::dvec3(seen.lower) - position), glm::abs(glm::dvec3(seen.upper) - position));
  const double far_distance = std::max({farthest.x, farthest.y, farthest.z}) * (1 + kPlaneSlack);
  if (!(far_distance > 0)) return Error{"there is nothing around the light but its own place"};
  return LightCube{.position = position, .near_distance = far_distance * kNearestPlane, .far_distance = far_distance};
}

Result<LightView> light_view(const LightCube& cube, int face) {
  return light_view(cube_face_camera({.eye = cube.position, .near_distance = cube.near_distance, .far_distance = cube.far_distance, .clip_volume = ClipVolume::zero_to_w}, face));
}

}  // namespace tuberia
