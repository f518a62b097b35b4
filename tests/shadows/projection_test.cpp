// Shadows on a floor and pictures thrown on it, at points where the answer is known.

#include <catch2/catch.hpp>

#include "tests/support/shadow_scenes.hpp"

namespace tuberia {

namespace {

constexpr int kFloorSide = 256;

/// The pixel of a picture by eye_above(half_width) that shows (x, z).
const Rgba32F& seen_at(const Image<Rgba32F>& picture, double half_width, double x, double z) {
  const auto pixel = [&](double c) { return static_cast<int>((c / half_width + 1) * 0.5 * picture.width()); };
  return picture.at(pixel(x), pixel(z));
}

Image<Rgba32F> floor_picture(test::ShadowScene& scene, double half_width) {
  scene.eye = test::eye_above(half_width);
  return test::visibility_picture(scene, test::shadow_map_of(scene, test::value_of(light_view(scene.light, scene.bounds()))), kFloorSide);
}

/// The direction in which what is dark lies, by its second moments, degrees from the x axis; left: x < 0.
double direction_of_shadow(const Image<Rgba32F>& picture, bool left) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (int j = 0; j < picture.height(); ++j)
    for (int i = 0; i < picture.width(); ++i) {
      if ((i < picture.width() / 2) != left || picture.at(i, j).r > 0.5f) continue;
      n += 1, x += i, y += j, xx += i * i, xy += i * j, yy += j * j;
    }
  REQUIRE(n > 100);
  return 0.5 * std::atan2(2 * (xy / n - x * y / n / n), xx / n - x * x / n / n - yy / n + y * y / n / n) * 180 / 3.14159265358979323846;
}

}  // namespace

TEST_CASE("shadows: of three points on the floor the middle one is behind something", "[shadows][A13]") {
  // A wall from (0, 0) to (0, 2): the lamp at (-4, 4) shades 0 < x < 4 of the floor.
  test::ShadowScene scene;
  scene.add(test::ground(8));
  scene.add_unseen(test::rectangle({0, 0, -3}, {0, 0, 6}, {0, 2, 0}, {-1, 0, 0}));
  scene.light = {.kind = Light::Kind::point, .towards = {-4, 4, 0}};
  const Image<Rgba32F> picture = floor_picture(scene, 8);
  const auto v = [&](double x) { return seen_at(picture, 8, x, 0).r; };
  CHECK(v(-2) == 1.0f);
  CHECK(v(2) == 0.0f);
  CHECK(v(6) == 1.0f);
  // And the shadow ends where the similar triangles say.
  CHECK(v(3.9) == 0.0f);
  CHECK(v(4.1) == 1.0f);
}

TEST_CASE("shadows: those of a sun are parallel, those of a lamp spread", "[shadows][A14]") {
  test::ShadowScene scene;
  scene.add(test::ground(8));
  for (const float x : {-2.0f, 2.0f}) scene.add_unseen(test::box({x - 0.05f, 0, -0.05f}, {x + 0.05f, 1.5f, 0.05f}));
  scene.light = {.kind = Light::Kind::directional, .towards = glm::normalize(glm::vec3(-1, 1.5f, -2))};
  const Image<Rgba32F> by_sun = floor_picture(scene, 5);
  const double along_the_sun = std::atan2(2.0, 1.0) * 180 / 3.14159265358979323846;
  CHECK(direction_of_shadow(by_sun, true) == Approx(along_the_sun).margin(0.5));
  CHECK(direction_of_shadow(by_sun, false) == Approx(along_the_sun).margin(0.5));

  scene.light = {.kind = Light::Kind::point, .towards = {0, 4, -4}};
  const Image<Rgba32F> by_lamp = floor_picture(scene, 5);
  const double right = std::atan2(4.0, 2.0) * 180 / 3.14159265358979323846;
  CHECK(direction_of_shadow(by_lamp, false) == Approx(right).margin(1.0));
  CHECK(direction_of_shadow(by_lamp, true) == Approx(-right).margin(1.0));
}

TEST_CASE("projected pictures: each texel falls where the light's rays take it", "[shadows][A19]") {
  // A projector at height 4 looks straight down through 90 degrees: the picture covers |x|, |z| <= 4.
  test::ShadowScene scene;
  scene.add(test::ground(8));
  scene.add_unseen(test::box({0.6f, 1, 0.6f}, {1.2f, 1.25f, 1.2f}));
  scene.light = {.kind = Light::Kind::point, .towards = {0, 4, 0}};
  const Camera projector{.eye = {0, 4, 0}, .point_of_interest = {0, 0, 0}, .up = {0, 0, -1}, .view = *perspective_volume(1.5707963267948966, 1, 0.5, 10)};
  const LightView view = test::value_of(light_view(projector));
  Image<Rgba8> slide(4, 4);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) slide.at(i, j) = {static_cast<std::uint8_t>(60 * i + 30), static_cast<std::uint8_t>(60 * j + 30), 200, 255};
  const ProjectedTexture projected{.texture = test::texture_of(slide), .map_from_world = view.map_from_world,
                                   .sampler = {.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none, .wrap_u = Wrap::clamp, .wrap_v = Wrap::clamp}};
  scene.eye = test::eye_above(6);
  const Image<Rgba32F> picture = test::visibility_picture(scene, test::shadow_map_of(scene, view), kFloorSide, projected);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const Rgba32F& at = seen_at(picture, 6, 2 * i - 3 + 0.2, 2 * j - 3 + 0.2);
      INFO("texel " << i << ", " << j);
      // The box hangs before the middle of the third texel of the third row: x, z of 0.87 to 1.6 at least.
      const bool shadowed = i == 2 && j == 2;
      const auto expected = [&](int code) { return shadowed ? 0.0f : static_cast<float>(code) / 255; };
      CHECK(at.r == Approx(expected(60 * i + 30)));
      CHECK(at.g == Approx(expected(60 * j + 30)));
      CHECK(at.b == Approx(expected(200)));
    }
  for (const auto& [x, z] : {std::pair{-4.2, 0.0}, {4.2, 0.0}, {0.0, -4.2}, {0.0, 4.2}, {5.0, 5.0}}) CHECK(seen_at(picture, 6, x, z).b == 0.0f);
}

TEST_CASE("projected pictures: nothing is thrown backwards", "[shadows][A19]") {
  test::ShadowScene scene;
  scene.add(test::rectangle({-8, 6, 8}, {16, 0, 0}, {0, 0, -16}, {0, 1, 0}));
  scene.eye = test::eye_above(6);
  const Camera projector{.eye = {0, 4, 0}, .point_of_interest = {0, 0, 0}, .up = {0, 0, -1}, .view = *perspective_volume(1.5707963267948966, 1, 0.5, 10)};
  const ProjectedTexture projected{.texture = test::texture_of(test::checkerboard(8, 1, {255, 255, 255, 255}, {255, 0, 0, 255})),
                                   .map_from_world = test::value_of(light_view(projector)).map_from_world};
  scene.light = {.kind = Light::Kind::directional, .towards = {0, 1, 0}};
  const Image<Rgba32F> picture = test::visibility_picture(scene, {}, 64, projected);
  for (const Rgba32F& pixel : picture.pixels()) REQUIRE(pixel.r == 0.0f);
}

}  // namespace tuberia
