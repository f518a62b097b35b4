// Shadow maps by rays, against what can be worked out by hand.

#include <catch2/catch.hpp>

#include <cmath>
#include <glm/geometric.hpp>

#include "examples/tuberia/witness/retraced_shadow.hpp"

namespace tuberia::witness {
namespace {

/// A parallel light straight down on a floor at y = 0, whose map has 8 x 8 texels of one unit around the origin.
RetracedShadow from_above(const description::Shadow& shadow) {
  Camera camera{.eye = {0, 10, 0}, .point_of_interest = {0, 0, 0}, .up = {0, 0, -1}, .projection = Projection::orthographic};
  camera.view = {.left = -4, .right = 4, .bottom = -4, .top = 4, .near_distance = 1, .far_distance = 20};
  camera.clip_volume = ClipVolume::zero_to_w;
  return RetracedShadow(shadow, *light_view(camera));
}

/// A half plane x < edge at the height 5 over the floor.
RetracedShadow::NearestCaster half_plane_over_floor(double edge) {
  return [edge](const tracer::Ray& ray) {
    const auto at_height = [&](double y) { return (y - ray.origin.y) / ray.direction.y; };
    return ray.at(at_height(5)).x < edge ? at_height(5) : at_height(0);
  };
}

const ShadowedPoint kOnFloor{.position = {0, 0, 0.5}, .normal = {0, 1, 0}, .to_light = {0, 1, 0}};

ShadowedPoint on_floor(double x) {
  ShadowedPoint point = kOnFloor;
  point.position.x = x;
  return point;
}

}  // namespace

TEST_CASE("tracer witness: one tap is the texel under the point", "[Y5][tracer_witness]") {
  const RetracedShadow shadow = from_above({.resolution = 8, .taps = 1});
  const auto nearest = half_plane_over_floor(0.25);
  // The texel [0, 1] has its middle at 0.5, beyond the edge: all of it is lit.
  for (const double x : {-3.9, -0.01}) CHECK(shadow.share_at(on_floor(x), nearest).high == 0);
  for (const double x : {0.01, 0.3, 3.9}) CHECK(shadow.share_at(on_floor(x), nearest).low == 1);
  // Outside of the picture all is lit.
  CHECK(shadow.share_at(on_floor(-4.1), nearest).low == 1);
}

TEST_CASE("tracer witness: two taps make the share linear from texel to texel", "[Y5][tracer_witness]") {
  const RetracedShadow shadow = from_above({.resolution = 8, .taps = 2});
  for (const double x : {-0.5, -0.25, 0.0, 0.4, 0.5}) {
    const ShareRange share = shadow.share_at(on_floor(x), half_plane_over_floor(0.25));
    CHECK(share.low == Approx(x + 0.5).margin(1e-12));
    CHECK(share.high == Approx(share.low));
  }
}

TEST_CASE("tracer witness: a texel whose middle an edge passes by less than 2/256 is in doubt", "[Y5][tracer_witness]") {
  const RetracedShadow shadow = from_above({.resolution = 8, .taps = 1});
  for (const double beside : {-1.9 / 256, 1.9 / 256}) {
    const ShareRange share = shadow.share_at(on_floor(0.2), half_plane_over_floor(0.5 + beside));
    CHECK(share.low == 0);
    CHECK(share.high == 1);
  }
  CHECK(shadow.share_at(on_floor(0.2), half_plane_over_floor(0.5 + 2.1 / 256)).high == 0);
  CHECK(shadow.share_at(on_floor(0.2), half_plane_over_floor(0.5 - 2.1 / 256)).low == 1);
}

TEST_CASE("tracer witness: a tilted plane shades itself without biases, and not with them", "[Y5][tracer_witness]") {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 1, 0.3));
  const auto plane = [&](const tracer::Ray& ray) { return -glm::dot(ray.origin, normal) / glm::dot(ray.direction, normal); };
  int dark = 0;
  for (int i = 0; i < 100; ++i) {
    ShadowedPoint point{.position = {-3 + 0.06 * i, 0, 0.017 * i}, .normal = normal, .to_light = {0, 1, 0}};
    point.position.y = -(point.position.x * normal.x + point.position.z * normal.z) / normal.y;
    dark += from_above({.resolution = 8, .slope_bias = 0, .taps = 2}).share_at(point, plane).high < 1 - 1e-12;
    for (const int taps : {1, 2, 3}) CHECK(from_above({.resolution = 8, .slope_bias = 1, .taps = taps}).share_at(point, plane).low > 1 - 1e-12);
    CHECK(from_above({.resolution = 8, .slope_bias = 0, .normal_offset = 1, .taps = 2}).share_at(point, plane).low > 1 - 1e-12);
  }
  CHECK(dark > 50);
}

TEST_CASE("tracer witness: a lamp all around has six pictures", "[Y5][tracer_witness]") {
  const RetracedShadow shadow({.resolution = 256, .taps = 1}, LightCube{.position = {0, 0, 0}, .near_distance = 0.01, .far_distance = 10});
  // A ball of radius 1/2 around (2, 0, 0), seen from the lamp under asin(1/4).
  const auto ball = [](const tracer::Ray& ray) {
    const glm::dvec3 offset = glm::dvec3(2, 0, 0) - ray.origin;
    const double along = glm::dot(offset, ray.direction), squared = 0.25 - (glm::dot(offset, offset) - along * along);
    return squared > 0 && along > 0 ? along - std::sqrt(squared) : tracer::kInfinity;
  };
  for (int i = 0; i < 64; ++i) {
    const double angle = 0.098 * i;
    const glm::dvec3 direction(std::cos(angle), 0.3 * std::sin(angle), 0.9 * std::sin(angle));
    const ShadowedPoint point{.position = 4.0 * direction, .normal = -glm::normalize(direction), .to_light = -glm::normalize(direction)};
    const double beside = std::acos(glm::normalize(direction).x) - std::asin(0.25);
    if (std::abs(beside) < 0.02) continue;  // two texels
    CAPTURE(angle, beside);
    CHECK(shadow.share_at(point, ball).low == (beside > 0 ? 1 : 0));
  }
}

}  // namespace tuberia::witness
