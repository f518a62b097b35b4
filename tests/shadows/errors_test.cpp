// What shadow maps get wrong, counted against rays: acne, detached shadows, stairs.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "tests/support/shadow_scenes.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

namespace {

constexpr int kErrorsSide = 128;

struct WrongPixels {
  int dark = 0;   // in shadow, though the light reaches them
  int light = 0;  // lit, though it does not
};

/// Over what faces the light.
WrongPixels wrong_pixels(const test::ShadowScene& scene, const ShadowMap& map) {
  const Image<Rgba32F> drawn = test::visibility_picture(scene, map, kErrorsSide);
  const test::RayScene rays = scene.rays();
  WrongPixels wrong;
  for (int y = 0; y < kErrorsSide; ++y)
    for (int x = 0; x < kErrorsSide; ++x) {
      const test::Ray ray = test::pixel_ray(scene.eye, x, y, kErrorsSide);
      const test::RayHit hit = rays.first_hit(ray);
      if (!hit) continue;
      const glm::dvec3 point = ray.at(hit.t), l = test::to_light(scene.light, point);
      if (glm::dot(hit.shading_normal, l) <= 0) continue;
      const bool lit = rays.is_visible(point, l, scene.light.kind == Light::Kind::directional), drawn_lit = drawn.at(x, y).r > 0.5f;
      if (lit && !drawn_lit) ++wrong.dark;
      if (!lit && drawn_lit) ++wrong.light;
    }
  return wrong;
}

struct Biases {
  float constant = 0, slope = 0, normal = 0;
};

ShadowMap with_biases(ShadowMap map, const Biases& biases) {
  map.constant_bias = biases.constant;
  map.slope_bias = biases.slope;
  map.normal_offset = biases.normal;
  return map;
}

}  // namespace

TEST_CASE("shadow errors: acne without bias, detached shadows with too much of it", "[shadows][A20]") {
  test::ShadowScene scene = test::cards_and_a_ball();
  const Light lamp{.kind = Light::Kind::point, .towards = {-3, 5, -5}};
  for (const Light& light : {test::kSunBehind, lamp}) {
    scene.light = light;
    const ShadowMap map = test::shadow_map_of(scene, test::value_of(light_view(light, scene.bounds())), {.size = 512});
    const WrongPixels none = wrong_pixels(scene, with_biases(map, {})), slope = wrong_pixels(scene, with_biases(map, {.slope = 1})),
                      normal = wrong_pixels(scene, with_biases(map, {.normal = 1})), constant = wrong_pixels(scene, with_biases(map, {.constant = 0.5f}));
    INFO("dark and light pixels wrong: none " << none.dark << " " << none.light << ", slope " << slope.dark << " " << slope.light << ", normal "
         << normal.dark << " " << normal.light << ", constant " << constant.dark << " " << constant.light);
    CHECK(none.dark > 2000);
    CHECK(slope.dark + slope.light < 50);
    CHECK(normal.dark + normal.light < 50);
    CHECK(constant.light > 5 * slope.light);
    CHECK(constant.dark < 50);
  }
}

TEST_CASE("shadow errors: a factor of 1 keeps a plane clean at any tilt, filter and size of the map", "[shadows][A20]") {
  test::Random random(431);
  for (int round = 0; round < 120; ++round) {
    test::ShadowScene scene;
    scene.add(test::ground(4));
    const int size = 32 << random.below(5), taps = 1 + static_cast<int>(random.below(4)), kind = static_cast<int>(random.below(3));
    const float elevation = random.between(0.05f, 1.5f), azimuth = random.between(0, 6.28f), distance = random.between(6, 30);
    const glm::vec3 towards(std::cos(elevation) * std::cos(azimuth), std::sin(elevation), std::cos(elevation) * std::sin(azimuth));
    scene.light = kind == 0 ? Light{.kind = Light::Kind::directional, .towards = towards}
                            : Light{.kind = Light::Kind::point, .towards = towards * (kind == 1 ? distance : 1.5f)};
    INFO("seed 431, round " << round << ": light (" << scene.light.towards.x << ", " << scene.light.towards.y << ", " << scene.light.towards.z << "), kind " << kind
         << ", " << size << " texels, " << taps << " taps");
    Pipeline pipeline({.threads = 1});
    ShadowMap map = kind == 2 ? test::value_of(draw_shadow_map(pipeline, scene.draws(), test::value_of(light_cube(scene.light, scene.bounds())), {.size = size}))
                              : test::value_of(draw_shadow_map(pipeline, scene.draws(), scene.light, scene.bounds(), {.size = size}));
    map.taps = taps;
    scene.eye = test::eye_above(3.9);
    for (const Biases& biases : {Biases{.constant = map.constant_bias, .slope = 1}, Biases{.constant = map.constant_bias, .normal = 1}}) {
      const Image<Rgba32F> drawn = test::visibility_picture(scene, with_biases(map, biases), kErrorsSide);
      const auto dark = std::count_if(drawn.pixels().begin(), drawn.pixels().end(), [](const Rgba32F& p) { return p.r < 1; });
      INFO("slope " << biases.slope);
      CHECK(dark == 0);
    }
  }
}

TEST_CASE("shadow errors: fewer with every doubling of the map", "[shadows][A20]") {
  test::ShadowScene scene = test::box_on_a_plane();
  scene.light = test::kSun;
  const LightView view = test::value_of(light_view(scene.light, scene.bounds()));
  int before = 1 << 30;
  for (const int size : {64, 128, 256, 512, 1024}) {
    const WrongPixels wrong = wrong_pixels(scene, test::shadow_map_of(scene, view, {.size = size}));
    INFO(size << " texels: " << wrong.dark << " dark and " << wrong.light << " light pixels wrong");
    CHECK(wrong.dark + wrong.light < 0.8 * before);
    before = wrong.dark + wrong.light;
  }
}

TEST_CASE("shadow errors: they show when the observer is close and the light far", "[shadows][A20]") {
  // One straight edge of a shadow, at x = 0, from further and further away: the same error in the world covers fewer pixels.
  test::ShadowScene scene;
  scene.add(test::ground(5));
  scene.add_unseen(test::rectangle({-2.7f, 1, 3}, {3, 0, 0}, {0, 0, -6}, {0, 1, 0}));
  scene.light = {.kind = Light::Kind::directional, .towards = glm::normalize(glm::vec3(0.3f, 1, 0.1f))};
  const ShadowMap map = test::shadow_map_of(scene, test::value_of(light_view(scene.light, scene.bounds())), {.size = 256});
  int before = 1 << 30;
  for (const double half_width : {0.25, 1.0, 4.0}) {
    scene.eye = test::eye_above(half_width);
    const Image<Rgba32F> drawn = test::visibility_picture(scene, map, kErrorsSide);
    int wrong = 0;
    for (int y = 0; y < kErrorsSide; ++y)
      for (int x = 0; x < kErrorsSide; ++x) {
        const double at_x = ((x + 0.5) / kErrorsSide * 2 - 1) * half_width, at_z = ((y + 0.5) / kErrorsSide * 2 - 1) * half_width;
        const bool shadowed = at_x < 0 && at_x > -3 && at_z + 0.1 < 3 && at_z + 0.1 > -3;
        if (shadowed == (drawn.at(x, y).r > 0.5f)) ++wrong;
      }
    INFO("half width " << half_width << ": " << wrong << " wrong");
    CHECK(wrong > 0);
    CHECK(2 * wrong < before);
    before = wrong;
  }
}

}  // namespace tuberia
