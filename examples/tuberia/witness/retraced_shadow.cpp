#include "examples/tuberia/witness/retraced_shadow.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tuberia::witness {
namespace {

// What two roundings of a depth may differ by counts as equal in the map, and its floats err by as much again.
constexpr double kDepthError = 0x1p-22, kDepthDoubt = 0x1p-22;
constexpr double kLeastCosine = 1e-3;   // where light grazes the slope's bias grows no more
constexpr double kSnapped = 2.0 / 256;  // texels: corners of casters are on a grid of 1/256

/// Weights of `taps` values in a row for a box of taps - 1 texels that begins at the fraction.
double weight_of(int i, int taps, double fraction) {
  if (taps == 1) return 1;
  const double whole = i == 0 ? 1 - fraction : i == taps - 1 ? fraction : 1;
  return whole / (taps - 1);
}

}  // namespace

glm::dvec3 RetracedShadow::Picture::seen(const glm::dvec3& point) const {
  const glm::dvec3 offset = point - eye;
  return {glm::dot(offset, basis.u), glm::dot(offset, basis.v), -glm::dot(offset, basis.w)};
}

double RetracedShadow::Picture::depth_at(double distance) const {
  const double range = far_distance - near_distance;
  return is_parallel ? (distance - near_distance) / range : far_distance / range * (1 - near_distance / distance);
}

RetracedShadow::Picture RetracedShadow::picture_of(const LightView& view) {
  const ViewVolume& volume = view.camera.view;
  const bool is_parallel = view.camera.projection == Projection::orthographic;
  const double window_distance = is_parallel ? 1 : volume.near_distance;
  return {.eye = view.camera.eye, .basis = *basis_of(view.camera), .upper_left = glm::dvec2(volume.left, volume.top) / window_distance,
          .size = glm::dvec2(volume.right - volume.left, volume.bottom - volume.top) / window_distance, .near_distance = volume.near_distance,
          .far_distance = volume.far_distance, .is_parallel = is_parallel, .position_error = static_cast<double>(view.position_error)};
}

RetracedShadow::RetracedShadow(const description::Shadow& shadow, const ShadowView& view) : shadow_(shadow) {
  if (const auto* one = std::get_if<LightView>(&view)) {
    pictures_.push_back(picture_of(*one));
    return;
  }
  for (int face = 0; face < 6; ++face) pictures_.push_back(picture_of(*light_view(std::get<LightCube>(view), face)));
}

/// Of a cube the face whose axis is nearest to the direction.
const RetracedShadow::Picture& RetracedShadow::picture_towards(const glm::dvec3& point) const {
  return *std::max_element(pictures_.begin(), pictures_.end(), [&](const Picture& a, const Picture& b) { return a.seen(point).z < b.seen(point).z; });
}

/// Moved by the biases, in heights h over the tangent plane that clear what the filter reads.
glm::dvec3 RetracedShadow::biased(const ShadowedPoint& point) const {
  const Picture& picture = picture_towards(point.position);
  const double reach = 0.5 * shadow_.taps + 1.0 / 256, distance = picture.is_parallel ? 1 : picture.seen(point.position).z;
  const glm::dvec2 texel = glm::abs(picture.size) / static_cast<double>(shadow_.resolution) * distance;
  const double height = reach * (std::abs(glm::dot(point.normal, picture.basis.u)) * texel.x + std::abs(glm::dot(point.normal, picture.basis.v)) * texel.y);
  const double towards_light = height / std::max(glm::dot(point.normal, point.to_light), kLeastCosine);
  return point.position + point.to_light * (towards_light * shadow_.slope_bias + shadow_.constant_bias + picture.position_error) +
         point.normal * (height * shadow_.normal_offset);
}

/// One texel's outcome: 0 or 1, or in between where it is in doubt.
ShareRange RetracedShadow::lit(const Picture& picture, const glm::dvec2& texel_middle, double reference_depth, const NearestCaster& nearest) const {
  constexpr glm::dvec2 kAround[] = {{0, 0}, {-kSnapped, -kSnapped}, {kSnapped, -kSnapped}, {-kSnapped, kSnapped}, {kSnapped, kSnapped}};
  ShareRange share{1, 0};
  for (const glm::dvec2& beside : kAround) {
    const glm::dvec2 at = picture.upper_left + (texel_middle + beside) / static_cast<double>(shadow_.resolution) * picture.size;
    const glm::dvec3 across = at.x * picture.basis.u + at.y * picture.basis.v, ahead = -picture.basis.w;
    tracer::Ray ray{.origin = picture.is_parallel ? picture.eye + across : picture.eye, .direction = picture.is_parallel ? ahead : glm::normalize(ahead + across)};
    const double forwards = glm::dot(ray.direction, ahead);
    ray.t_min = picture.near_distance / forwards;
    ray.t_max = picture.far_distance / forwards;
    const double t = nearest(ray), depth = std::isfinite(t) ? picture.depth_at(t * forwards) : 1;
    const double over = reference_depth - kDepthError - depth;  // above 0: behind what the light sees
    share.low = std::min(share.low, depth < 1 && over > -kDepthDoubt ? 0.0 : 1.0);
    share.high = std::max(share.high, depth < 1 && over > kDepthDoubt ? 0.0 : 1.0);
  }
  return share;
}

/// taps x taps texels around the place; beyond the picture its edge texels.
ShareRange RetracedShadow::filtered(const TexelPlace& place, const NearestCaster& nearest) const {
  const int taps = shadow_.taps;
  const glm::dvec2 corner = place.texels - 0.5 * (taps - 1), first = glm::floor(corner), fraction = corner - first;
  const double depth = place.picture->depth_at(place.distance), last = shadow_.resolution - 1;
  ShareRange sum{0, 0};
  for (int j = 0; j < taps; ++j)
    for (int i = 0; i < taps; ++i) {
      const glm::dvec2 texel = glm::clamp(first + glm::dvec2(i, j), glm::dvec2(0), glm::dvec2(last));
      const ShareRange one = lit(*place.picture, texel + 0.5, depth, nearest);
      const double weight = weight_of(i, taps, fraction.x) * weight_of(j, taps, fraction.y);
      sum.low += weight * one.low;
      sum.high += weight * one.high;
    }
  return sum;
}

ShareRange RetracedShadow::share_at(const ShadowedPoint& point, const NearestCaster& nearest) const {
  if (!(glm::dot(point.normal, point.to_light) > 0)) return {0, 0};
  const glm::dvec3 compared = biased(point);
  const Picture& picture = picture_towards(compared);
  const glm::dvec3 seen = picture.seen(compared);
  if (!picture.is_parallel && !(seen.z > 0)) return {1, 1};
  const glm::dvec2 at = (glm::dvec2(seen) / (picture.is_parallel ? 1 : seen.z) - picture.upper_left) / picture.size;
  if (!(at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1)) return {1, 1};
  return filtered({.picture = &picture, .texels = at * static_cast<double>(shadow_.resolution), .distance = seen.z}, nearest);
}

}  // namespace tuberia::witness
