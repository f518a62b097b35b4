// Exposure, and what becomes of intensities that no screen can show.

#include <catch2/catch.hpp>

#include <limits>

#include "math/colour.hpp"
#include "scene/content/develop.hpp"

namespace tuberia {
namespace {

using Handling = description::Overflow;  // of what overflows; the surface program has an Overflow of its own

Rgba32F developed_pixel(const Rgba32F& pixel, const description::Picture& picture) { return developed(Image<Rgba32F>(1, 1, pixel), picture).at(0, 0); }

}  // namespace

TEST_CASE("develop: a stop doubles what arrives", "[C07][frame]") {
  const Rgba32F dim{0.1f, 0.2f, 0.3f, 1};
  CHECK(developed_pixel(dim, {.exposure_stops = 0}) == dim);
  CHECK(developed_pixel(dim, {.exposure_stops = 1}) == Rgba32F{0.2f, 0.4f, 0.6f, 1});
  CHECK(developed_pixel(dim, {.exposure_stops = -2}) == Rgba32F{0.025f, 0.05f, 0.075f, 1});
  CHECK(developed_pixel(dim, {.exposure_stops = 0.5}).r == Approx(0.1 * 1.41421356));
  CHECK(developed_pixel({0.25f, 0.5f, 1, 0.5f}, {.exposure_stops = 2, .overflow = Handling::hue_preserving}) == Rgba32F{0.25f, 0.5f, 1, 0.5f});
}

TEST_CASE("develop: what overflows is cut off, or scaled by pixel or by picture", "[B16][B18][frame]") {
  const Rgba32F bright{1.6f, 0.8f, 0.4f, 1};  // test vectors 15.8
  CHECK(developed_pixel(bright, {.overflow = Handling::clamp}) == Rgba32F{1, 0.8f, 0.4f, 1});
  const Rgba32F hue = developed_pixel(bright, {.overflow = Handling::hue_preserving});
  CHECK(hue.r == 1);
  CHECK(hue.g == Approx(0.5));
  CHECK(hue.b == Approx(0.25));
  Image<Rgba32F> two(2, 1, bright);
  two.at(1, 0) = {0.1f, 2, 0.1f, 1};
  const Rgba32F scaled = developed(two, {.overflow = Handling::global_scale}).at(0, 0);
  CHECK(scaled.r == Approx(0.8));
  CHECK(scaled.g == Approx(0.4));
  CHECK(scaled.b == Approx(0.2));
}

TEST_CASE("develop: what is no number is black, what is infinite is white", "[frame][bad]") {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  for (const Handling overflow : {Handling::clamp, Handling::global_scale, Handling::hue_preserving}) {
    CAPTURE(static_cast<int>(overflow));
    const Rgba32F pixel = developed_pixel({nan, infinity, -1, 1}, {.overflow = overflow});
    CHECK(pixel == Rgba32F{0, 1, 0, 1});
  }
}

TEST_CASE("develop: codes are the nearest sRGB codes", "[frame]") {
  Image<Rgba32F> row(256, 1);
  for (int i = 0; i < 256; ++i) row.at(i, 0) = {linear_from_srgb_codes()[static_cast<std::size_t>(i)], 0, 1, 0.5f};
  const Image<Rgba8> codes = srgb_codes_of(row);
  for (int i = 0; i < 256; ++i) CHECK(codes.at(i, 0) == Rgba8{static_cast<std::uint8_t>(i), 0, 255, 128});
}

}  // namespace tuberia
