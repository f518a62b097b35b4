// The metrics that judge pictures, against published and derived values: cases 73 and 74.

#include <catch2/catch.hpp>

#include <limits>

#include "image/compare.hpp"

namespace tuberia {

namespace {

Image<Rgba8> grey_image(int width, int height, std::uint8_t code) { return Image<Rgba8>(width, height, {code, code, code, 255}); }

}  // namespace

TEST_CASE("metrics: CIEDE2000 gives the values that Sharma et al. published", "[extremes][case-74]") {
  struct Pair {
    Lab first, second;
    double expected;
  };
  const Pair pairs[] = {
      {{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
      {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
      {{50, 0, 0}, {50, -1, 2}, 2.3669},
      {{50, 2.49, -0.001}, {50, -2.49, 0.0009}, 7.1792},
      {{50, 2.49, -0.001}, {50, -2.49, 0.0011}, 7.2195},
      {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
      {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
  };
  for (const auto& [first, second, expected] : pairs) {
    CAPTURE(first.l, first.a, first.b, second.l, second.a, second.b);
    CHECK(ciede2000(first, second) == Approx(expected).margin(1e-4));
    CHECK(ciede2000(second, first) == Approx(expected).margin(1e-4));
    CHECK(ciede2000(first, first) == 0.0);
  }
}

TEST_CASE("metrics: all pixels off by one code is 48.13 dB", "[extremes][case-73]") {
  const Result<Comparison> result = compare(grey_image(40, 30, 100), grey_image(40, 30, 101));
  REQUIRE(result.ok());
  CHECK(result->psnr_db == Approx(48.1308036086791).epsilon(1e-14));
  CHECK(result->largest_difference == 1);
  CHECK(result->differing_pixels == 40 * 30);
  CHECK(!result->equal);
  CHECK(compare(grey_image(40, 30, 100), grey_image(40, 30, 100))->psnr_db == std::numeric_limits<double>::infinity());
}

TEST_CASE("metrics: SSIM of constant images is what the formula gives", "[extremes][case-73]") {
  const auto [width, height] =
      GENERATE(std::pair{1, 1}, std::pair{5, 200}, std::pair{11, 11}, std::pair{64, 48});
  CAPTURE(width, height);
  CHECK(compare(grey_image(width, height, 100), grey_image(width, height, 110))->ssim ==
        Approx(0.9954764440915066).epsilon(1e-9));
  CHECK(compare(grey_image(width, height, 0), grey_image(width, height, 255))->ssim ==
        Approx(9.999e-5).epsilon(1e-4));
}

}  // namespace tuberia
