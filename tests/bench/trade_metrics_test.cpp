#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <vector>

#include "bench/trade/picture_error.hpp"
#include "bench/trade/probe_geometry.hpp"
#include "bench/figures/timing.hpp"

namespace tuberia::bench::trade {
namespace {

Image<Rgba32F> grey_picture(double code) {
  const auto value = static_cast<float>(code / 255);
  return Image<Rgba32F>(24, 16, {value, value, value, 1});
}

}  // namespace

TEST_CASE("picture error: one code everywhere is 48.13 dB", "[bench][trade][case-73]") {
  const auto error = picture_error(grey_picture(100), grey_picture(101));
  REQUIRE(error);
  CHECK(error->largest_code == Approx(1).epsilon(1e-5));
  CHECK(error->rmse_codes == Approx(1).epsilon(1e-5));
  CHECK(error->differing_share == 1);
  CHECK(error->psnr_db == Approx(48.1308036086791));
}

TEST_CASE("picture error: floats may differ by less than a code", "[bench][trade]") {
  Image<Rgba32F> picture = grey_picture(100);
  picture.at(3, 5).g += 0.25f / 255;
  const auto error = picture_error(picture, grey_picture(100));
  REQUIRE(error);
  CHECK(error->largest_code == Approx(0.25).epsilon(1e-4));
  CHECK(error->rmse_codes == Approx(0.25 / std::sqrt(3.0 * 24 * 16)).epsilon(1e-4));
  CHECK(error->differing_share == 0);
  CHECK(std::isinf(error->psnr_db));
}

TEST_CASE("picture error: equal pictures have none, whatever is in them", "[bench][trade]") {
  Image<Rgba32F> picture = grey_picture(7);
  picture.at(0, 0) = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -3, 1};
  const auto error = picture_error(picture, picture);
  REQUIRE(error);
  CHECK(error->largest_code == 0);
  CHECK(error->rmse_codes == 0);
  CHECK(error->ssim == 1);
}

TEST_CASE("picture error: linear light is compared as the screen's codes", "[bench][trade]") {
  // sRGB code 188 is 0.502886 of the light of white, code 0 none.
  const auto value = 0.502886f;
  const auto error =
      picture_error(Image<Rgba32F>(2, 2, {value, value, value, 1}), Image<Rgba32F>(2, 2, {0, 0, 0, 1}), Signal::linear);
  REQUIRE(error);
  CHECK(error->largest_code == Approx(188).margin(0.05));
  CHECK_FALSE(picture_error(grey_picture(1), Image<Rgba32F>(3, 3)));
  CHECK_FALSE(picture_error({}, {}));
}

TEST_CASE("probe geometry: the parts of a polygon in all pixels make its whole area", "[bench][trade]") {
  const std::vector<std::vector<glm::dvec2>> polygons{{{1.25, 1.5}, {14.1, 3.3}, {6.2, 12.9}},
                                                      {{6.2, 12.9}, {14.1, 3.3}, {1.25, 1.5}},
                                                      {{2, 2}, {9, 2}, {9, 7}, {2, 7}},
                                                      {{8.1, 1.2}, {13.7, 8.3}, {7.9, 14.6}, {2.2, 7.7}},
                                                      {{3.1, 3.2}, {3.3, 3.4}, {3.15, 3.45}}};
  for (const auto& polygon : polygons) {
    double twice = 0, sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      twice += a.x * b.y - b.x * a.y;
    }
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) sum += covered_area(polygon, x, y);
    CHECK(sum == Approx(std::abs(twice) / 2));
  }
  CHECK(covered_area(polygons[2], 4, 4) == 1);
  CHECK(covered_area(polygons[2], 1, 4) == 0);
  CHECK(covered_area(std::vector<glm::dvec2>{{0, 0}, {1, 0}, {0, 1}}, 0, 0) == Approx(0.5));
}

TEST_CASE("probe geometry: a triangle holds the centres that it holds, turned either way", "[bench][trade]") {
  constexpr std::int64_t kPixel = 1 << kFineBits;
  const std::array<FinePoint, 3> triangle{{{0, 0}, {10 * kPixel, 0}, {0, 10 * kPixel}}},
      turned{{triangle[0], triangle[2], triangle[1]}};
  int covered = 0;
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x) {
      CHECK(covers_centre(triangle, x, y) == (x + y + 1 < 10));  // centres on the long side are on the edge
      CHECK(covers_centre(turned, x, y) == covers_centre(triangle, x, y));
      covered += covers_centre(triangle, x, y) ? 1 : 0;
    }
  CHECK(covered == 45);
  CHECK(perimeter(triangle) == Approx(20 + std::sqrt(200.0)));
}

TEST_CASE("timing: every way runs, in every round; the first is the measure of all", "[bench][trade]") {
  int first = 0, second = 0;
  const auto spin = [](int steps) {
    volatile int sink = 0;
    for (int i = 0; i < steps; ++i) sink = sink + i;
  };
  const std::vector<std::function<void()>> ways{[&] {
                                                  ++first;
                                                  spin(20'000);
                                                },
                                                [&] {
                                                  ++second;
                                                  spin(200'000);
                                                }};
  const std::vector<RelativeTime> times = time_in_turns(ways, {.seconds = 0, .fewest_rounds = 5, .of_processor = true});
  REQUIRE(times.size() == 2);
  CHECK(times[0].ratio == 1);
  CHECK(times[0].rounds == 5);
  CHECK(times[1].rounds == 5);
  CHECK(times[1].ratio > 2);  // ten times the work, on a machine that may be busy
  CHECK(times[1].lower_quartile <= times[1].ratio);
  CHECK(times[1].ratio <= times[1].upper_quartile);
  CHECK(first > second);  // the shorter one is run more often in a row
}

}  // namespace tuberia::bench::trade
