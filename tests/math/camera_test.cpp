#include "math/camera.hpp"

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace tuberia {

namespace {

bool inside_clip_volume(const glm::vec4& clip, ClipVolume volume) {
  const float low = volume == ClipVolume::zero_to_w ? 0.0f : -clip.w;
  return clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && clip.z >= low && clip.z <= clip.w;
}

glm::dvec3 random_direction(std::mt19937& random) {
  std::normal_distribution<double> coordinate;
  return glm::normalize(glm::dvec3(coordinate(random), coordinate(random), coordinate(random)));
}

}  // namespace

TEST_CASE("camera: the point of interest is in the middle of the picture", "[math]") {
  Camera camera{.eye = {3, 4, 5}, .point_of_interest = {1, -1, 0}};
  camera.projection = GENERATE(Projection::perspective, Projection::orthographic);
  const auto matrices = camera_matrices(camera);
  REQUIRE(matrices.ok());
  const glm::vec4 clip = matrices->clip_from_world * glm::vec4(1, -1, 0, 1);
  CHECK(clip.x == Approx(0.0).margin(1e-5));
  CHECK(clip.y == Approx(0.0).margin(1e-5));
  CHECK(inside_clip_volume(clip, camera.clip_volume));
  CHECK(matrices->clip_from_world == compose(matrices->clip_from_view, matrices->view_from_world));
}

TEST_CASE("camera: errors of the basis and of the view come through", "[math][bad-input]") {
  const auto parallel = camera_matrices({.eye = {0, 1, 0}});
  REQUIRE_FALSE(parallel.ok());
  CHECK_THAT(parallel.error().message, Catch::Contains("parallel"));
  const auto behind = camera_matrices({.view = {.near_distance = -1}});
  REQUIRE_FALSE(behind.ok());
  CHECK_THAT(behind.error().message, Catch::Contains("near_distance is -1"));
}

TEST_CASE("camera: a framed sphere is wholly visible from every direction", "[math]") {
  std::mt19937 random(20240611);
  for (const double azimuth : {0.0, 30.0, 180.0, -250.0})
    for (const double elevation : {-90.0, -20.0, 0.0, 45.0, 90.0})
      for (const double fovy_degrees : {10.0, 45.0, 120.0})
        for (const double aspect : {0.5, 1.0, 16.0 / 9.0}) {
          const Framing wish{.centre = {10, -3, 2}, .radius = 0.75, .azimuth_degrees = azimuth,
                             .elevation_degrees = elevation,
                             .fovy_radians = fovy_degrees * std::numbers::pi / 180, .aspect = aspect,
                             .clip_volume = ClipVolume::zero_to_w};
          const auto camera = framing(wish);
          REQUIRE(camera.ok());
          CHECK(camera->view.near_distance > 0.0);
          const auto matrices = camera_matrices(*camera);
          REQUIRE(matrices.ok());
          bool all_inside = true;
          for (int i = 0; i < 200; ++i) {
            const glm::vec3 point(wish.centre + wish.radius * random_direction(random));
            all_inside &= inside_clip_volume(matrices->clip_from_world * glm::vec4(point, 1), wish.clip_volume);
          }
          CHECK(all_inside);
        }
}

TEST_CASE("camera: a framing comes close and is tight in depth", "[math]") {
  const auto camera = framing({.radius = 2, .fovy_radians = std::numbers::pi / 3, .aspect = 1});
  REQUIRE(camera.ok());
  const double distance = glm::length(camera->eye);
  CHECK(distance == Approx(4.0).epsilon(2e-3));
  CHECK(camera->view.near_distance == Approx(2.0).epsilon(5e-3));
  CHECK(camera->view.far_distance == Approx(6.0).epsilon(5e-3));
}

TEST_CASE("camera: azimuth turns from +z towards +x and elevation rises to +y", "[math]") {
  const auto eye_direction = [](double azimuth, double elevation) {
    const auto camera = framing({.azimuth_degrees = azimuth, .elevation_degrees = elevation});
    REQUIRE(camera.ok());
    return glm::normalize(camera->eye);
  };
  CHECK(glm::distance(eye_direction(0, 0), {0, 0, 1}) < 1e-12);
  CHECK(glm::distance(eye_direction(90, 0), {1, 0, 0}) < 1e-12);
  CHECK(glm::distance(eye_direction(0, 90), {0, 1, 0}) < 1e-12);
}

TEST_CASE("camera: a box is framed by the sphere around it", "[math]") {
  const Framing wish = framing_of_box({-1, 0, 2}, {1, 4, 6});
  CHECK(wish.centre == glm::dvec3(0, 2, 4));
  CHECK(wish.radius == Approx(3.0));
  CHECK(framing_of_box({1, 1, 1}, {1, 1, 1}).radius == 1.0);
}

TEST_CASE("camera: impossible framings are refused by name and value", "[math][bad-input]") {
  const auto message = [](const Framing& wish) {
    const auto camera = framing(wish);
    REQUIRE_FALSE(camera.ok());
    return camera.error().message;
  };
  CHECK_THAT(message({.radius = 0}), Catch::Contains("radius is 0"));
  CHECK_THAT(message({.centre = {0, std::numeric_limits<double>::infinity(), 0}}), Catch::Contains("centre is inf"));
  CHECK_THAT(message({.elevation_degrees = 91}), Catch::Contains("elevation_degrees is 91"));
  CHECK_THAT(message({.fovy_radians = 4}), Catch::Contains("fovy_radians is 4"));
  CHECK_THAT(message({.aspect = -1}), Catch::Contains("aspect is -1"));
}

}  // namespace tuberia
