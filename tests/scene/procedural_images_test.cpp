#include <catch2/catch.hpp>

#include <cmath>
#include <map>

#include "math/colour.hpp"
#include "scene/procedural_images.hpp"

namespace tuberia {
namespace {

double red_change(const Image<Rgba8>& image, int x, int other_x) {
  double sum = 0;
  for (int y = 0; y < image.height(); ++y) sum += std::abs(image.at(x, y).r - image.at(other_x, y).r);
  return sum / image.height();
}

}  // namespace

TEST_CASE("procedural images: a planet has sea, land and ice, and no seam", "[scene][procedural][B35]") {
  const Image<Rgba8> map = planet_image(256, 128), heights = planet_height_image(256, 128);
  int sea = 0, ice = 0, land = 0;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 256; ++x) {
      const Rgba8& c = map.at(x, y);
      const bool is_sea = c.b > c.r + 40 && c.b > c.g + 20, is_ice = c.r > 200 && c.b > 200;
      (is_ice ? ice : is_sea ? sea : land) += 1;
      if (is_sea) CHECK(heights.at(x, y).r == 0);
    }
  CHECK(sea > 256 * 128 / 5);
  CHECK(land > 256 * 128 / 5);
  CHECK(ice > 256 * 128 / 50);
  CHECK((map.at(10, 0).r > 200 && map.at(10, 127).r > 200));  // the poles

  double inside = 0;
  for (int x = 1; x < 256; ++x) inside = std::max(inside, red_change(map, x, x - 1));
  CHECK(red_change(map, 0, 255) <= inside);
  CHECK_FALSE(planet_image(64, 32, 1) == planet_image(64, 32, 2));
}

TEST_CASE("procedural images: bricks repeat, and their heights are those of the picture", "[scene][procedural]") {
  const Image<Rgba8> wall = brick_image(128, 128), heights = brick_height_image(128, 128);
  int mortar = 0;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      const bool is_low = heights.at(x, y).r == 0;
      mortar += is_low ? 1 : 0;
      if (is_low) CHECK(wall.at(x, y).b > 100);          // grey
      else CHECK(wall.at(x, y).r > wall.at(x, y).b + 20);  // red
    }
  // Rims of 0.06 courses around bricks of 2 by 1: 1 - 1.88 * 0.88 / 2 of the wall.
  CHECK(mortar / (128.0 * 128) == Approx(1 - 1.88 * 0.88 / 2).margin(0.03));
  for (int y = 0; y < 128; ++y) CHECK(std::abs(heights.at(0, y).r - heights.at(127, y).r) <= 255 / 4);
}

TEST_CASE("procedural images: studs are round, and there are as many as asked for", "[scene][procedural]") {
  const Image<Rgba8> studs = stud_height_image(120, 120, 6);
  int tops = 0;
  double area = 0;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) {
      area += studs.at(x, y).r > 0 ? 1 : 0;
      if (x % 20 == 10 && y % 20 == 10 && studs.at(x, y).r > 250) ++tops;
    }
  CHECK(tops == 36);
  CHECK(area / (120 * 120) == Approx(3.14159 * 0.35 * 0.35).margin(0.02));
}

TEST_CASE("procedural images: pictures of normals are the slopes of heights", "[scene][procedural]") {
  const Image<Rgba8> flat = normal_image(Image<Rgba8>(8, 8, {77, 77, 77, 255}), 1);
  for (const Rgba8& n : flat.pixels()) CHECK(n == Rgba8{128, 128, 255, 255});

  Image<Rgba8> ramp(16, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x) ramp.at(x, y) = {static_cast<std::uint8_t>(10 * x), 0, 0, 255};
  // 10 / 255 of the relief a pixel, which is a sixteenth of the width.
  const double slope = 10 / 255.0 * 0.5 * 16, length = std::sqrt(1 + slope * slope);
  const Rgba8 normal = normal_image(ramp, 0.5).at(8, 4);
  CHECK(std::abs(normal.r - (127.5 - 127.5 * slope / length)) <= 0.5);
  CHECK(std::abs(normal.b - (127.5 + 127.5 / length)) <= 0.5);

  Image<Rgba8> downhill(8, 16);  // higher rows further down: facing up in the picture
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 8; ++x) downhill.at(x, y).r = static_cast<std::uint8_t>(10 * y);
  CHECK(normal_image(downhill, 0.5).at(4, 8).g > 140);
}

TEST_CASE("procedural images: a pattern's pixels are means over their areas", "[scene][procedural]") {
  const Image<Rgba8> coarse = pattern_image({.kind = Pattern::Kind::checker, .scale = 8}, 4, 4);
  for (const Rgba8& pixel : coarse.pixels()) CHECK(pixel.r == srgb_code_from_linear(0.5));
  const Image<Rgba8> fine = pattern_image({.kind = Pattern::Kind::checker, .scale = 8}, 64, 64);
  CHECK((fine.at(2, 2).r == 255 && fine.at(10, 2).r == 0));
  for (const Pattern::Kind kind : {Pattern::Kind::wood, Pattern::Kind::marble}) {
    std::map<int, int> codes;
    const Image<Rgba8> solid = pattern_image({.kind = kind, .scale = 6}, 64, 64);
    for (const Rgba8& pixel : solid.pixels()) ++codes[pixel.r];
    CHECK(codes.size() > 50);
  }
}

}  // namespace tuberia
