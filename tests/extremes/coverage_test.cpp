// Which pixels a triangle covers, in exact arithmetic: cases 01 to 12 of the rules, by the kernels of
// every instruction set and through the whole pipeline.

#include <catch2/catch.hpp>

#include "tests/support/drawn_coverage.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/triangles.hpp"

namespace tuberia {

using test::Coverage;
using test::covered;
using test::for_every_instruction_set;
using test::Triangle;

namespace {

std::uint64_t count_of_one(const Triangle& triangle, int width, int height, InstructionSet set) {
  const Coverage coverage = covered({&triangle, 1}, width, height, set);
  CHECK(coverage == test::covered_by_definition({&triangle, 1}, width, height));
  CHECK(test::published(test::drawn_sums({&triangle, 1}, width, height, {.threads = 1, .instruction_set = set})).hash == coverage.hash);
  return coverage.count;
}

/// A set through the kernels of every instruction set, and through the pipeline on one and on several threads.
void check_published(std::span<const Triangle> triangles, int width, int height, const test::PublishedCoverage& right,
                     std::optional<std::int64_t> empty = {}) {
  for_every_instruction_set([&](InstructionSet set) {
    const Coverage coverage = covered(triangles, width, height, set);
    CHECK(coverage.count == right.count);
    CHECK(coverage.hash == right.hash);
    if (empty) CHECK(coverage.empty_triangles() == *empty);
    for (const int threads : {1, 7}) {
      INFO(threads << " threads");
      CHECK((test::published(test::drawn_sums(triangles, width, height, {.threads = threads, .instruction_set = set})) == right));
    }
  });
}

/// As the rules write it: pixels, here of 256 units.
Triangle in_pixels(double x0, double y0, double x1, double y1, double x2, double y2) {
  return {SnappedPoint{snap(x0), snap(y0)}, {snap(x1), snap(y1)}, {snap(x2), snap(y2)}};
}

}  // namespace

TEST_CASE("coverage: two halves of a square share its diagonal without overlap", "[extremes][R2][R3][case-01]") {
  for_every_instruction_set([](InstructionSet set) {
    const Triangle halves[2] = {in_pixels(0, 0, 8, 0, 8, 8), in_pixels(0, 0, 8, 8, 0, 8)};
    const Coverage both = covered(halves, 8, 8, set);
    CHECK(both.pixels_of == std::vector<std::uint32_t>{36, 28});
    CHECK(both.pixels_with_owners() == 64);
    CHECK(both.most_owners() == 1);
  });
}

TEST_CASE("coverage: a centre on an edge belongs to the left and the top one only", "[extremes][R2][case-02]") {
  for_every_instruction_set([](InstructionSet set) {
    CHECK(count_of_one(in_pixels(0.5, 0.5, 1.5, 0.5, 0.5, 1.5), 4, 4, set) == 1);
    CHECK(count_of_one(in_pixels(1.5, 1.5, 0.5, 1.5, 1.5, 0.5), 4, 4, set) == 0);
    const Triangle owner = in_pixels(0.5, 0.5, 1.5, 0.5, 0.5, 1.5);
    CHECK(covered({&owner, 1}, 4, 4, set).owners_at(0, 0) == 1);
  });
}

TEST_CASE("coverage: triangles smaller than a pixel are decided by its centre", "[extremes][R2][case-03]") {
  for_every_instruction_set([](InstructionSet set) {
    CHECK(count_of_one({SnappedPoint{0, 0}, {127, 0}, {0, 127}}, 4, 4, set) == 0);
    CHECK(count_of_one({SnappedPoint{127, 127}, {130, 128}, {127, 129}}, 4, 4, set) == 1);
  });
}

TEST_CASE("coverage: a sliver one unit high covers its row or nothing", "[extremes][R2][case-04]") {
  for_every_instruction_set([](InstructionSet set) {
    CHECK(count_of_one({SnappedPoint{128, 128}, {256128, 129}, {256128, 128}}, 1024, 1024, set) == 1000);
    CHECK(count_of_one({SnappedPoint{128, 127}, {256128, 128}, {128, 128}}, 1024, 1024, set) == 0);
    CHECK(count_of_one({SnappedPoint{128, 127}, {256128, 128}, {128, 129}}, 1024, 1024, set) == 1000);
  });
}

TEST_CASE("coverage: a diagonal sliver covers the diagonal or nothing", "[extremes][R2][case-05]") {
  for_every_instruction_set([](InstructionSet set) {
    CHECK(count_of_one({SnappedPoint{0, 0}, {262144, 262144}, {262144, 262145}}, 1024, 1024, set) == 0);
    CHECK(count_of_one({SnappedPoint{0, 0}, {262144, 262143}, {262144, 262144}}, 1024, 1024, set) == 1024);
    CHECK(count_of_one({SnappedPoint{0, 0}, {262144, 262145}, {262144, 262143}}, 1024, 1024, set) == 1024);
  });
}

TEST_CASE("coverage: the snap is to nearest, ties to even", "[extremes][R1][case-06]") {
  CHECK(snap(10.001953125) == 2560);
  CHECK(snap(10.005859375) == 2562);
  CHECK(snap(-10.001953125) == -2560);
  CHECK(snap(-10.005859375) == -2562);
  CHECK(snap(255.998046875) == 65536);
  CHECK(snap(0.001953125) == 0);
}

TEST_CASE("coverage: a doubled area of one unit has a sign, one of zero has none", "[extremes][R4][case-07]") {
  const Triangle plus{SnappedPoint{-8388608, -8388608}, {8388607, 8388606}, {-8388607, -8388607}};
  const Triangle minus{SnappedPoint{-8388608, -8388608}, {8388607, 8388606}, {8388606, 8388605}};
  CHECK(twice_area(plus[0], plus[1], plus[2]) == 1);
  CHECK(twice_area(minus[0], minus[1], minus[2]) == -1);
  for_every_instruction_set([&](InstructionSet set) {
    const auto kept = [&](const Triangle& t) { return test::TriangleSet({&t, 1}, 64, 64, set, test::kEverything).kept(); };
    CHECK(kept(plus) == 1);
    CHECK(kept(minus) == 1);
    CHECK(kept({plus[0], plus[1], plus[0]}) == 0);
    CHECK(kept({SnappedPoint{0, 0}, {1000, 2000}, {2000, 4000}}) == 0);
  });
}

TEST_CASE("coverage: two thousand random triangles match the published counts", "[extremes][R2][case-08]") {
  struct Published {
    std::uint64_t seed, count, hash;
    std::int64_t low, high, empty;
  };
  for (const Published& p : {Published{1, 10115389, 0x13687ddb2cf21, 0, 65536, 1},
                             Published{7, 29544683, 0x36ce45a36b1cf, -65536, 131072, 367}})
    check_published(test::random_triangles(p.seed, 2000, p.low, p.high), 256, 256, {p.count, p.hash}, p.empty);
  const auto turned = [](const Triangle& t) { return twice_area(t[0], t[1], t[2]) > 0; };
  const auto triangles = test::random_triangles(1, 2000, 0, 65536);
  CHECK(std::count_if(triangles.begin(), triangles.end(), turned) == 987);
  const auto turned_back = [](const Triangle& t) { return twice_area(t[0], t[1], t[2]) < 0; };
  CHECK(std::count_if(triangles.begin(), triangles.end(), turned_back) == 1013);
}

TEST_CASE("coverage: a large triangle owns the one centre of a tile that lies on its left edge", "[extremes][R2]") {
  for_every_instruction_set([](InstructionSet set) {
    // Edges that fall and rise at 45 degrees through the centre of a tile's last pixel and of the last one of its first row.
    for (const double reach : {200.0, 1500.0, 3000.0, 30000.0}) {
      const Triangle falling = in_pixels(63.5 - reach, 63.5 + reach, 63.5 + reach, 63.5 - reach, 63.5 + reach, 63.5 + reach);
      const Triangle rising = in_pixels(63.5 - reach, 64.5 - reach, 63.5 + reach, 64.5 - reach, 63.5 + reach, 64.5 + reach);
      for (const Triangle& triangle : {falling, rising}) {
        const Coverage coverage = covered({&triangle, 1}, 192, 192, set);
        CHECK(coverage == test::covered_by_definition({&triangle, 1}, 192, 192));
      }
      CHECK(covered({&falling, 1}, 192, 192, set).owners_at(63, 63) == 1);
      CHECK(covered({&falling, 1}, 192, 192, set).owners_at(62, 63) == 0);
      CHECK(covered({&rising, 1}, 192, 192, set).owners_at(63, 64) == 1);
    }
  });
}

TEST_CASE("coverage: triangles that reach the whole guard band stay exact", "[extremes][R2][case-09]") {
  check_published(test::random_triangles(5, 500, -8388608, 8388607), 128, 96, {1244971, 0x1ae06591e68}, 398);
}

TEST_CASE("coverage: twenty thousand small triangles match the published counts", "[extremes][R2][case-10]") {
  check_published(test::small_triangles(3, 20000, 128, 128), 128, 128, {8407, 0x9d80d3a256}, 12605);
}

TEST_CASE("coverage: a fan about a pixel's centre covers it once", "[extremes][R3][case-11]") {
  const auto fan = test::fan_about_a_centre();
  const Image<Rgba32F> sums = test::drawn_sums(fan, 64, 64, {.threads = 3});
  for (const Rgba32F& sum : sums.pixels()) CHECK(sum.g <= 1);
  for_every_instruction_set([&](InstructionSet set) {
    const Coverage coverage = covered(fan, 64, 64, set);
    CHECK(coverage.most_owners() == 1);
    CHECK(coverage.owners_at(32, 32) == 1);
    CHECK(coverage.count == 1246);
  });
}

TEST_CASE("coverage: a jittered mesh covers every pixel once", "[extremes][R3][case-12]") {
  const auto mesh = test::jittered_mesh();
  check_published(mesh, 128, 96, {12288, 0x50081fb9f});
  for_every_instruction_set([&](InstructionSet set) {
    const Coverage coverage = covered(mesh, 128, 96, set);
    CHECK(coverage.most_owners() == 1);
    CHECK(coverage.pixels_with_owners() == 12288);
  });
}

}  // namespace tuberia
