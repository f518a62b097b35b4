// Shadow maps at their limits: cases 55 and 56.

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/shadow_scenes.hpp"

namespace tuberia {

namespace {

constexpr double kPi = 3.14159265358979323846, kTexel = 10.0 / 512;

/// A floor, a sun `degrees` from its normal towards +x, and a map of 512 texels over 10 units; `turn_degrees`
/// turns the map's axes against the direction in which the floor's depth grows.
struct TiltedFloor {
  test::ShadowScene scene;
  ShadowMap map;
  double degrees;

  TiltedFloor(double degrees_, double turn_degrees, bool with_wall = false) : degrees(degrees_) {
    const double angle = degrees * kPi / 180, turn = turn_degrees * kPi / 180;
    scene.add(test::ground(400));
    if (with_wall) scene.add_unseen(test::rectangle({0, 0, -4}, {0, 0, 8}, {0, 3, 0}, {1, 0, 0}));
    const glm::dvec3 towards{std::sin(angle), std::cos(angle), 0};
    scene.light = {.kind = Light::Kind::directional, .towards = glm::vec3(towards)};
    const glm::dvec3 across{0, 0, 1}, along = glm::cross(towards, across);
    const Camera camera{.eye = {0, 0, 0}, .point_of_interest = -towards, .up = along * std::cos(turn) + across * std::sin(turn), .projection = Projection::orthographic,
                        .view = {.left = -5, .right = 5, .bottom = -5, .top = 5, .near_distance = -400, .far_distance = 400}, .clip_volume = ClipVolume::zero_to_w};
    map = test::shadow_map_of(scene, test::value_of(light_view(camera)), {.size = 512});
    scene.eye = test::eye_above(1);
    // Across the floor the map's texels are long: look at about 100 of them.
    scene.eye.view.left = -50 * kTexel / std::cos(angle);
    scene.eye.view.right = -scene.eye.view.left;
  }

  Image<Rgba32F> picture(float constant, float slope, float normal_offset) const {
    ShadowMap biased = map;
    biased.constant_bias = constant;
    biased.slope_bias = slope;
    biased.normal_offset = normal_offset;
    return test::visibility_picture(scene, biased, 512);
  }

  int acne(double constant, float slope, float normal_offset) const {
    int dark = 0;
    const Image<Rgba32F> drawn = picture(static_cast<float>(constant), slope, normal_offset);
    for (const Rgba32F& pixel : drawn.pixels()) dark += pixel.r < 1;
    return dark;
  }

  /// How far behind the wall its shadow begins, in texels of the map.
  double gap_in_texels(float slope, float normal_offset) const {
    const Image<Rgba32F> drawn = picture(0, slope, normal_offset);
    // The sun stands at +x: the shadow falls to -x. A dark run of a few pixels, not one speck.
    int x = 255;
    while (x > 0 && drawn.at(x, 256).r > 0.5f) --x;
    return (255 - x) * (scene.eye.view.right / 256) * std::cos(degrees * kPi / 180) / kTexel;
  }
};

}  // namespace

TEST_CASE("shadow maps: the least bias of a tilted floor, and what it costs", "[extremes][case-55]") {
  for (const auto& [degrees, least] : {std::pair{45.0, .009766}, {80.0, .055384}, {89.0, .559472}}) {
    CHECK(0.5 * kTexel * std::tan(degrees * kPi / 180) == Approx(least).epsilon(1e-4));
    for (const double turn : {0.0, 45.0}) {
      INFO(degrees << " degrees, axes turned by " << turn);
      const TiltedFloor floor(degrees, turn);
      const double needed = turn == 0 ? least : least * std::sqrt(2.0);
      // As a constant: 1/256 more for snapped vertices.
      CHECK(floor.acne(needed * 0.9, 0, 0) > 0);
      CHECK(floor.acne(needed * (1 + 1.0 / 128), 0, 0) == 0);
      // As multiples of what the tilt asks for.
      CHECK(floor.acne(0, 0, 0) > 100000);
      CHECK(floor.acne(0, 0.9f, 0) > 0);
      CHECK(floor.acne(0, 1, 0) == 0);
      CHECK(floor.acne(0, 0, 0.9f) > 0);
      CHECK(floor.acne(0, 0, 1) == 0);
    }
    const TiltedFloor floor(degrees, 0, true);
    CHECK(floor.gap_in_texels(1, 0) <= 2);
    CHECK(floor.gap_in_texels(0, 1) <= 2);
  }
}

TEST_CASE("shadow maps: the outline of a square's shadow", "[extremes][case-56]") {
  test::ShadowScene scene;
  scene.add(test::ground(3));
  scene.add_unseen(test::rectangle({-0.5f, 1, 0.5f}, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}));
  scene.light = {.kind = Light::Kind::directional, .towards = glm::normalize(glm::vec3(-0.5f, 1, -0.25f))};
  scene.eye = test::eye_above(2);
  const LightView view = test::value_of(light_view(scene.light, scene.bounds()));
  for (const int size : {256, 1024}) {
    const ShadowMap map = test::shadow_map_of(scene, view, {.size = size});
    const Image<Rgba32F> drawn = test::visibility_picture(scene, map, 1024);
    // The longest side of a texel's footprint on the floor.
    const double texel = std::max(glm::length(map.texel_right), glm::length(map.texel_down)) / scene.light.towards.y, pixel = 4.0 / 1024;
    double area = 0;
    for (int j = 0; j < 1024; ++j)
      for (int i = 0; i < 1024; ++i) {
        const double x = (i + 0.5) * pixel - 2, z = (j + 0.5) * pixel - 2;
        const bool shadowed = drawn.at(i, j).r < 0.5f;
        area += shadowed ? pixel * pixel : 0;
        const double outside = std::max(std::max(-x, x - 1), std::max(-0.25 - z, z - 0.75));
        if (std::abs(outside) > texel) REQUIRE(shadowed == (outside < 0));
      }
    INFO("map " << size << ", texel " << texel << ", area " << area);
    CHECK(std::abs(area - 1) <= 0.5 * texel * 4);
  }
}

}  // namespace tuberia
