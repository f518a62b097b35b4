#include <catch2/catch.hpp>

#include <cmath>

#include "bench/figures/schedule.hpp"
#include "bench/figures/statistics.hpp"

namespace tuberia::bench {

TEST_CASE("statistics: the median of an even number lies between the middle two", "[bench]") {
  CHECK(median({5, 1, 3}) == 3);
  CHECK(median({4, 1, 3, 100}) == 3.5);
}

TEST_CASE("statistics: a quantile lies between its neighbours by their distance", "[bench]") {
  CHECK(quantile({40, 10, 20, 30, 50}, 0.25) == 20);
  CHECK(quantile({1, 2}, 0.75) == 1.75);
  CHECK(quantile({7}, 0.25) == 7);
  CHECK(quantile({3, 1, 2}, 1) == 3);
}

TEST_CASE("statistics: the geometric mean of ratios is the same both ways round", "[bench]") {
  const std::vector<double> ratios{2, 8, 0.5}, inverse{0.5, 0.125, 2};
  CHECK(geometric_mean(ratios) == Approx(2));
  CHECK(geometric_mean(ratios) * geometric_mean(inverse) == Approx(1));
}

TEST_CASE("power law: the exponent and factor of exact data come back, without error", "[bench]") {
  std::vector<CurvePoint> points;
  for (const double x : {1.0, 10.0, 100.0, 1000.0}) points.push_back({x, 3 * std::pow(x, 1.25)});
  const auto law = fit_power_law(points);
  REQUIRE(law);
  CHECK(law->exponent == Approx(1.25));
  CHECK(law->factor == Approx(3));
  REQUIRE(law->standard_error);
  CHECK(*law->standard_error == Approx(0).margin(1e-9));
}

TEST_CASE("power law: the standard error is that of the regression", "[bench]") {
  // Logarithms x = 0, 1, 2 and y = 0, 1.3, 2: slope 1, residuals -0.1, 0.2, -0.1; so the error is
  // sqrt((0.01 + 0.04 + 0.01) / 1 / 2).
  const double e = std::exp(1.0);
  const std::vector<CurvePoint> points{{1, 1}, {e, std::exp(1.3)}, {e * e, e * e}};
  const auto law = fit_power_law(points);
  REQUIRE(law);
  CHECK(law->exponent == Approx(1));
  REQUIRE(law->standard_error);
  CHECK(*law->standard_error == Approx(std::sqrt(0.03)));
}

TEST_CASE("power law: what determines no line gives none", "[bench]") {
  CHECK_FALSE(fit_power_law(std::vector<CurvePoint>{{1, 1}}));
  CHECK_FALSE(fit_power_law(std::vector<CurvePoint>{{2, 1}, {2, 3}}));
  const auto two = fit_power_law(std::vector<CurvePoint>{{1, 1}, {2, 4}});
  REQUIRE(two);
  CHECK(two->exponent == Approx(2));
  CHECK_FALSE(two->standard_error);
}

TEST_CASE("power law: the upper end shows what a fixed cost hides", "[bench]") {
  std::vector<CurvePoint> points;
  for (double x = 1e6; x >= 1; x /= 10) points.push_back({x, 1000 + x * x});
  CHECK(fit_power_law(points)->exponent < 1.7);
  const auto end = fit_upper_end(points);
  REQUIRE(end);
  CHECK(end->exponent == Approx(2).margin(0.01));
  CHECK(end->from == Approx(1e4));
  CHECK(end->to == 1e6);
}

TEST_CASE("schedule: whoever is free takes the next item", "[bench]") {
  const Loop items{3, 3, 2, 2, 2};  // the text-book case: 6 would be possible, in order it takes 7
  CHECK(makespan(items, 1) == 12);
  CHECK(makespan(items, 2) == 7);
  CHECK(makespan(items, 5) == 3);
  CHECK(makespan(items, 64) == 3);
  CHECK(makespan(Loop{}, 4) == 0);
}

TEST_CASE("schedule: loops wait for one another, and time alone is never shared", "[bench]") {
  const Work work{.loops = {{4, 1, 1, 1, 1}, {2, 2}}, .draws = {}, .alone = 1};
  CHECK(work.total() == 13);
  CHECK(work.longest_chain(2) == 7);
  CHECK(work.duration(1) == 13);
  CHECK(work.duration(2) == 7);
  CHECK(work.duration(64) == 7);
  CHECK(work.balance(1) == 1);
  CHECK(work.balance(2) == Approx(13.0 / 14));
}

TEST_CASE("schedule: n threads make n batches of a draw into one, but never two draws", "[bench]") {
  const Batch batch{.chunks = {3}, .tiles = {1, 2}};
  const Work one_draw{.loops = {}, .draws = {{batch, batch, batch}}};
  CHECK(one_draw.total() == 18);
  CHECK(one_draw.duration(1) == 18);
  CHECK(one_draw.duration(2) == 3 + 2 + 3 + 2);  // chunks 3 3; tiles 2 4, and after the short one the third batch's chunk; its tiles 1 2
  CHECK(one_draw.duration(3) == 3 + 6);          // chunks 3 3 3, tiles 3 6
  CHECK(one_draw.longest_chain(3) == 9);
  CHECK(one_draw.longest_chain(1) == 9);

  const Work two_draws{.loops = {}, .draws = {{batch}, {batch}}};
  CHECK(two_draws.duration(2) == 2 * (3 + 2));
}

TEST_CASE("schedule: who is free goes ahead with the next batch, as far as memory goes", "[bench]") {
  const Batch uneven{.chunks = {1, 9}, .tiles = {2, 2}}, even{.chunks = {4, 4, 4, 4}, .tiles = {1}};
  // The first thread does a chunk of the next batch beside the chunk of 9, and a second one: two go ahead. The third waits for the tiles.
  CHECK(duration_of(std::vector{uneven, even}, 2) == 9 + 2 + 4 + 1);
  CHECK(duration_of(std::vector{uneven, even}, 1) == 14 + 17);
  // Two threads may go ahead by two chunks, not more: this batch has six, four of which must wait for the long tile.
  const Batch long_tile{.chunks = {1, 1, 1, 1, 1, 1}, .tiles = {20}}, many{.chunks = {5, 5, 5, 5, 5, 5}, .tiles = {1}};
  CHECK(duration_of(std::vector{long_tile, many}, 2) == 3 + 20 + 10 + 1);
  CHECK(duration_of(std::vector<Batch>{}, 2) == 0);
}

TEST_CASE("schedule: no number of threads beats the longest chain or an even share", "[bench]") {
  Work work{.loops = {{}, {}}, .draws = {{}}, .alone = 0.5};
  for (int i = 0; i < 300; ++i) work.loops[static_cast<std::size_t>(i % 2)].push_back(1 + (i * 7919 % 31));
  for (int i = 0; i < 20; ++i)
    work.draws[0].push_back({.chunks = {1.0 + i * 31 % 7, 2, 3}, .tiles = {0.1, 1.0 + i * 17 % 5, 4, 1}});
  for (int threads = 1; threads <= 64; threads *= 2) {
    CHECK(work.duration(threads) >= work.longest_chain(threads));
    CHECK(work.duration(threads) * threads >= Approx(work.total()));
    CHECK(work.balance(threads) <= Approx(1));
  }
}

}  // namespace tuberia::bench
