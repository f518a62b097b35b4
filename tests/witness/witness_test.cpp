// The pipeline against rational arithmetic, on triangles made to hurt; and the witness itself against
// numbers that need no witness.

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>

#include "tests/support/random.hpp"
#include "tests/witness/tally.hpp"

namespace tuberia::witness {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::int64_t kTriangles = 200'000;

TEST_CASE("witness: coverage, clipping and depth codes are those of rational arithmetic", "[witness][exact]") {
  Workers workers;
  std::vector<Machines> machines(static_cast<std::size_t>(workers.thread_count()));
  Tally total;
  for (int i = 0; i < kClasses; ++i) {
    const auto kind = static_cast<Class>(i);
    const Tally tally = run(kind, kSeed, 0, kTriangles / kClasses, workers, machines);
    INFO("seed " << kSeed << ", class " << name_of(kind));
    if (!tally.failures.empty()) {
      INFO("case " << tally.failures.front() << ": " << explained(random_case(kind, kSeed, tally.failures.front()), machines[0]));
      CHECK(tally.failed == 0);
    }
    // A class that draws nothing shows nothing.
    CHECK(tally.pixels > 1000);
    // The contract's own roundings may decide a few; were it many, they would hide mistakes.
    CHECK(tally.undecided * 200 <= tally.tried);
    total += tally;
  }
  CHECK(total.undecided * 1000 <= total.tried);
  CHECK(total.tried >= kTriangles - kClasses);
}

TEST_CASE("witness: a corner that rounding has left without a place is drawn as the contract says", "[witness]") {
  // Found as case 18570 of the bit patterns: one corner is (8e-24, 2e-23, -2e16, 2e-27) in double.
  constexpr std::uint32_t kBits[3][4] = {{0xb7000000, 0x19800000, 0x4b800000, 0xf4800000},
                                         {0x4c800000, 0x20800000, 0x50800000, 0x12000000},
                                         {0x4a000000, 0x0d000000, 0x98000000, 0x7c800000}};
  Case c{.view = {.viewport = {0, 0, 16, 8}, .lowest_z = 0}, .width = 16, .height = 8, .is_counting = true, .vertices = {}};
  for (const auto& bits : kBits)
    c.vertices.push_back({std::bit_cast<float>(bits[0]), std::bit_cast<float>(bits[1]), std::bit_cast<float>(bits[2]), std::bit_cast<float>(bits[3])});
  Machines machines;
  const Finding finding = compare(c, machines);
  INFO(finding.what);
  CHECK(finding.verdict != Verdict::failed);
}

TEST_CASE("witness: a quotient's nearest float is the processor's", "[witness]") {
  test::Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const auto any = [&] {
      const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random.u64()));
      return std::isfinite(value) && value != 0 ? value : 1.0f;
    };
    const float a = any(), b = any();
    const rational::Dyadic n = rational::dyadic(static_cast<double>(a)), d = rational::dyadic(static_cast<double>(std::abs(b)));
    const rational::Quotient q{static_cast<long>(n.mantissa), static_cast<long>(d.mantissa), std::int64_t{n.exponent} - d.exponent};
    INFO("seed 5: " << a << " / " << b);
    CHECK(rational::nearest_float(q) == a / std::abs(b));
  }
}

TEST_CASE("witness: ties go to the even neighbour", "[witness]") {
  const auto whole = [](long n, long d) { return rational::nearest_whole({n, d, 0}, 1000); };
  CHECK(whole(1, 2) == 0);
  CHECK(whole(3, 2) == 2);
  CHECK(whole(5, 2) == 2);
  CHECK(whole(-5, 2) == -2);
  CHECK(whole(-3, 2) == -2);
  CHECK(whole(7, 3) == 2);
  CHECK(whole(123456, 1) == 1000);
  CHECK(rational::nearest_float({(1L << 24) + 1, 1, 0}) == 0x1p24f);
  CHECK(rational::nearest_float({(1L << 24) + 3, 1, 0}) == 0x1p24f + 4);
  CHECK(rational::nearest_float({1, 1, -150}) == 0);
  CHECK(rational::nearest_float({3, 1, -150}) == std::ldexp(1.0f, -148));
  CHECK(rational::nearest_float({(1L << 25) - 1, 1, 103}) == std::numeric_limits<float>::infinity());
}

TEST_CASE("witness: the quad of case 17 and the triangle of case 18", "[witness][case17][case18]") {
  const rational::Volume volume{1, 1, 0};
  const auto ndc = [](const rational::Polygon& polygon, std::size_t i, rational::Integer rational::Corner::*coordinate) {
    const rational::Corner& corner = polygon.corners[i];
    return mpq_class(mpq_class(corner.*coordinate) / mpq_class(corner.w));
  };
  const rational::Polygon quad = rational::clipped({{{-0.5f, -0.5f, 0.5f, 1}, {0.5f, -0.5f, 0.5f, 1}, {0, 0.5f, -0.5f, 1}}}, volume);
  REQUIRE(quad.corners.size() == 4);
  CHECK(ndc(quad, 2, &rational::Corner::x) == mpq_class(1, 4));
  CHECK(ndc(quad, 2, &rational::Corner::y) == 0);
  CHECK(ndc(quad, 3, &rational::Corner::x) == mpq_class(-1, 4));

  const rational::Polygon behind = rational::clipped({{{0, 0.5f, 0.25f, 1}, {0.5f, -0.5f, 0.25f, 1}, {0, 0, -2, -1}}}, volume);
  REQUIRE(behind.corners.size() == 4);
  CHECK(ndc(behind, 2, &rational::Corner::x) == mpq_class(4, 7));
  CHECK(ndc(behind, 2, &rational::Corner::y) == mpq_class(-4, 7));
  CHECK(ndc(behind, 3, &rational::Corner::y) == mpq_class(4, 7));
}

}  // namespace
}  // namespace tuberia::witness
