#include "math/colour.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace tuberia {

namespace {

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
constexpr float kFloatNaN = std::numeric_limits<float>::quiet_NaN();

// The definition of srgb_code_thresholds, read from the table alone.
int code_by_thresholds(float x) {
  int code = 0;
  while (x >= srgb_code_thresholds()[static_cast<std::size_t>(code) + 1]) ++code;
  return code;
}

}  // namespace

TEST_CASE("colour: the sRGB curve meets its known points", "[math]") {
  CHECK(linear_from_srgb(0.0) == 0.0);
  CHECK(linear_from_srgb(1.0) == Approx(1.0).epsilon(1e-15));
  CHECK(linear_from_srgb(0.5) == Approx(0.21404114048223255).epsilon(1e-14));
  CHECK(srgb_from_linear(0.0031308) == Approx(0.04045).margin(1e-7));
  CHECK(linear_from_srgb_codes().front() == 0.0f);
  CHECK(linear_from_srgb_codes().back() == 1.0f);
}

TEST_CASE("colour: every sRGB code survives the way to linear light and back", "[math]") {
  for (int code = 0; code < 256; ++code) {
    const float linear = linear_from_srgb_codes()[static_cast<std::size_t>(code)];
    CHECK(srgb_code_from_linear(linear) == code);
    CHECK(code_by_thresholds(linear) == code);
  }
}

TEST_CASE("colour: each threshold is the first float of its code", "[math]") {
  const auto& thresholds = srgb_code_thresholds();
  CHECK(thresholds.front() == -kFloatInfinity);
  CHECK(thresholds.back() == kFloatInfinity);
  for (int code = 1; code < 256; ++code) {
    const float threshold = thresholds[static_cast<std::size_t>(code)];
    CHECK(srgb_code_from_linear(threshold) == code);
    CHECK(srgb_code_from_linear(std::nextafter(threshold, 0.0f)) == code - 1);
  }
}

TEST_CASE("colour: sRGB encoding clamps and sends NaN to 0", "[math]") {
  CHECK(srgb_code_from_linear(-0.5) == 0);
  CHECK(srgb_code_from_linear(1.5) == 255);
  CHECK(srgb_code_from_linear(kFloatInfinity) == 255);
  CHECK(srgb_code_from_linear(-kFloatInfinity) == 0);
  CHECK(srgb_code_from_linear(kFloatNaN) == 0);
}

// rules, case 46 and B1
TEST_CASE("colour: unorm8 rounds halves up, clamps, and sends NaN to 0", "[math]") {
  CHECK(unorm8_from_linear(0.5f) == 128);
  CHECK(unorm8_from_linear(static_cast<float>(1.0 / 510.0 - 1e-9)) == 0);
  CHECK(unorm8_from_linear(static_cast<float>(1.0 / 510.0 + 1e-9)) == 1);
  CHECK(unorm8_from_linear(-0.0f) == 0);
  CHECK(unorm8_from_linear(-1.0f) == 0);
  CHECK(unorm8_from_linear(kFloatNaN) == 0);
  CHECK(unorm8_from_linear(kFloatInfinity) == 255);
  CHECK(unorm8_from_linear(std::nextafter(1.0f, 0.0f)) == 255);
  for (int code = 0; code < 256; ++code) CHECK(unorm8_from_linear(static_cast<float>(code) / 255.0f) == code);
}

}  // namespace tuberia
