// The known figures of [rules 4] that can be derived, against the closed forms; where a known figure comes of a few
// random trials, its tolerance says so.

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <vector>

#include "bench/trade/closed_forms.hpp"

namespace tuberia::bench::trade {
namespace {

/// Right to the last digit that is on record: half of it.
auto to_digit(double value, double last_digit) { return Approx(value).margin(0.5000001 * last_digit).epsilon(0); }

}  // namespace

TEST_CASE("closed forms: rounding vertices costs pixels in proportion to the grid", "[bench][trade][rules-4]") {
  CHECK(wrong_pixels_by_rounding(0) == Approx(190).epsilon(0.03));
  CHECK(wrong_pixels_by_rounding(2) == Approx(48.5).epsilon(0.03));
  CHECK(wrong_pixels_by_rounding(4) == Approx(12.9).epsilon(0.07));
  CHECK(wrong_pixels_by_rounding(8) == Approx(wrong_pixels_by_rounding(0) / 256));
}

TEST_CASE("closed forms: rounding along one axis and at one end alone would cost a quarter of a unit",
          "[bench][trade]") {
  // An upper bound: no vertex moves farther than half a diagonal, on average by .3826 units, and an edge less.
  CHECK(wrong_pixels_by_rounding(0) < 1000 * 0.3826);
  CHECK(wrong_pixels_by_rounding(0) > 1000 * 0.125);
}

TEST_CASE("closed forms: perspective every few pixels", "[bench][trade][rules-4]") {
  CHECK(texel_error_by_steps(2, 4) == to_digit(0.03, 0.01));
  CHECK(texel_error_by_steps(2, 8) == to_digit(0.12, 0.01));
  CHECK(texel_error_by_steps(2, 16) == to_digit(0.46, 0.01));
  CHECK(texel_error_by_steps(2, 32) == to_digit(1.7, 0.1));
  CHECK(texel_error_by_steps(2, 64) == to_digit(5.7, 0.1));
  CHECK(texel_error_by_steps(2, 256) == to_digit(43.9, 0.1));
  CHECK(texel_error_by_steps(10, 8) == Approx(3.8).epsilon(0.02));
  CHECK(texel_error_by_steps(10, 16) == to_digit(11.4, 0.1));
  CHECK(texel_error_by_steps(100, 8) == Approx(65.6).epsilon(0.01));  // depends on where the steps begin
  // Affine, w to 2: t - t / (2 - t) is largest at t = 2 - sqrt 2.
  CHECK(texel_error_by_steps(2, 256) == Approx(256 * (3 - 2 * std::sqrt(2.0))).epsilon(1e-3));
  for (const double w : {2.0, 10.0, 100.0})
    for (int step = 2; step <= 256; step *= 2) CHECK(texel_error_by_steps(w, step) <= texel_error_bound(w, step));
}

TEST_CASE("closed forms: pairs of surfaces in the wrong order", "[bench][trade][rules-4][case-31]") {
  struct Known {
    double gap, d16, d24, d32f;
  };
  for (const auto& [gap, d16, d24, d32f] :
       {Known{1e-3, .549, .082, .082}, {1e-4, .750, .267, .267}, {1e-5, .942, .468, .468}, {1e-6, .994, .667, .668}}) {
    CAPTURE(gap);
    CHECK(misordered_pairs(DepthCoding::unorm16, gap) == Approx(d16).margin(0.003));
    CHECK(misordered_pairs(DepthCoding::unorm24, gap) == Approx(d24).margin(0.003));
    CHECK(misordered_pairs(DepthCoding::float32, gap) == Approx(d32f).margin(0.003));
    CHECK(misordered_pairs(DepthCoding::float32_reversed, gap) == 0);
  }
}

TEST_CASE("closed forms: coverage by samples", "[bench][trade][rules-4]") {
  const auto grid = [](int side) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < side * side; ++i)
      points.emplace_back((i % side + 0.5) / side - 0.5, (i / side + 0.5) / side - 0.5);
    return points;
  };
  constexpr double kAll = 0.78539816339744831;
  CHECK(coverage_rms(grid(1), kAll) == Approx(0.243).epsilon(0.03));
  CHECK(coverage_rms(grid(2), kAll) == Approx(0.085).epsilon(0.03));
  CHECK(coverage_rms(grid(3), kAll) == Approx(0.046).epsilon(0.03));
  CHECK(coverage_rms(grid(4), kAll) == Approx(0.030).epsilon(0.03));
  CHECK(coverage_rms(grid(8), kAll) == Approx(0.0105).epsilon(0.03));
  // Along an axis the one sample's error is spread evenly over -1/2..1/2, an n x n grid's over -1/2n..1/2n.
  CHECK(coverage_rms(grid(1), 0) == Approx(1 / std::sqrt(12.0)).epsilon(1e-3));
  CHECK(coverage_rms(grid(4), 0) == Approx(0.25 / std::sqrt(12.0)).epsilon(1e-3));
}

TEST_CASE("closed forms: shading", "[bench][trade][rules-4][case-54]") {
  CHECK(gouraud_highlight(10, 20) == to_digit(.736, .001));
  CHECK(gouraud_highlight(20, 50) == to_digit(.0446, .0001));
  CHECK(gouraud_highlight(30, 10) == to_digit(.237, .001));
  CHECK(mean_normal_length(20) == to_digit(.98481, 1e-5));
  CHECK(mean_normal_length(90) == to_digit(.70711, 1e-5));
  CHECK(length_after_one_step(10) == to_digit(.99998, 1e-5));
  CHECK(length_after_one_step(20) == to_digit(.9997, 1e-4));
  CHECK(length_after_one_step(40) == to_digit(.9947, 1e-4));
  CHECK(length_after_one_step(60) == to_digit(.974, 1e-3));
  CHECK(length_after_one_step(90) == to_digit(.884, 1e-3));
}

TEST_CASE("closed forms: approximations", "[bench][trade][rules-4]") {
  CHECK(schlick_power_error(5) == to_digit(.155, .001));
  CHECK(schlick_power_error(10) == to_digit(.179, .001));
  CHECK(schlick_power_error(20) == to_digit(.191, .001));
  CHECK(schlick_power_error(50) == to_digit(.199, .002));
  CHECK(schlick_power_error(200) == to_digit(.202, .001));
  CHECK(schlick_fresnel_error(1.33) == to_digit(.060, .001));
  CHECK(schlick_fresnel_error(1.5) == to_digit(.036, .001));
  CHECK(schlick_fresnel_error(2.42) == to_digit(.076, .001));
  CHECK(fast_inverse_root_error(0) == to_digit(3.4e-2, 1e-3));
  CHECK(fast_inverse_root_error(1) == to_digit(1.75e-3, 1e-5));
  CHECK(fast_inverse_root_error(2) == to_digit(4.7e-6, 1e-7));
  CHECK(fast_inverse_root_error(3) == to_digit(1.4e-7, 1e-8));
}

TEST_CASE("closed forms: targets", "[bench][trade][rules-4][case-45]") {
  for (const auto& [layers, code, exact] : {std::tuple{1, 254, 254.0},
                                            {10, 245, 245.1746},
                                            {100, 155, 172.1448},
                                            {255, 127, 93.6250},
                                            {1000, 127, 5.0128}}) {
    CHECK(white_under_layers_in_codes(layers) == code);
    CHECK(white_under_layers(layers) == to_digit(exact, 1e-4));
  }
  CHECK(srgb_codes_kept_by_linear_codes() == 183);
  CHECK(codes_missed_by_plain_gamma() == 9);
}

TEST_CASE("closed forms: footprints", "[bench][trade][rules-4][case-38]") {
  CHECK(ellipse_level_of_detail({3, 1}, {-1, 2}, 16) == to_digit(1.13263, 1e-5));
  CHECK(axis_level_of_detail({3, 1}, {-1, 2}, 16) == to_digit(1.16096, 1e-5));
  CHECK(ellipse_level_of_detail({5, 0}, {4.9, 0.5}, 16) == to_digit(-1.19069, 1e-5));
  CHECK(axis_level_of_detail({5, 0}, {4.9, 0.5}, 16) == to_digit(2.30025, 1e-5));
}

}  // namespace tuberia::bench::trade
