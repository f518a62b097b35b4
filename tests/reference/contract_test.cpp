// The documents fix weights and depths as a few float operations. Here these are held against the
// rational numbers that they stand for: the contract is a good one.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "reference/oracle/coverage.hpp"
#include "tests/support/random.hpp"

namespace tuberia::oracle {
namespace {

struct LargestErrors {
  double weight = 0, depth = 0;
};

/// Weights and depths at covered pixels of random triangles with vertices within +-reach pixels of a
/// 64x64 square, against long double from the exact integers.
LargestErrors errors_of_triangles(std::uint64_t seed, std::int64_t reach_pixels, int samples) {
  test::Random random(seed);
  LargestErrors most;
  for (int i = 0; i < 2000; ++i) {
    ScreenPrimitive primitive;
    for (ScreenVertex& v : primitive.vertex) {
      v.x = random.below(2 * 256 * reach_pixels) - 256 * reach_pixels + 32 * 256;
      v.y = random.below(2 * 256 * reach_pixels) - 256 * reach_pixels + 32 * 256;
      v.depth = random.between(0, 1);
    }
    if (doubled_area(primitive.vertex[0], primitive.vertex[1], primitive.vertex[2]) == 0) continue;
    const Draw draw;
    const Shape shape(primitive, draw, samples);
    for (int k = 0; k < 40; ++k) {
      const int x = static_cast<int>(random.below(64)), y = static_cast<int>(random.below(64));
      const int s = static_cast<int>(random.below(samples));
      if (!shape.covers(x, y, s)) continue;
      const SampleOffset offset = sample_offset(samples, s);
      const ScreenVertex p{256 * x + 128 + offset.x, 256 * y + 128 + offset.y, 0, 1, {}, {}};
      const auto area = static_cast<long double>(doubled_area(shape.vertex(0), shape.vertex(1), shape.vertex(2)));
      const long double w1 = static_cast<long double>(doubled_area(shape.vertex(2), shape.vertex(0), p)) / area;
      const long double w2 = static_cast<long double>(doubled_area(shape.vertex(0), shape.vertex(1), p)) / area;
      const auto z = [&](std::size_t v) { return static_cast<long double>(shape.vertex(v).depth); };
      const long double depth = z(0) + (z(1) - z(0)) * w1 + (z(2) - z(0)) * w2;
      const Weights w = shape.weights(x, y);
      if (samples == 1) most.weight = std::max({most.weight, std::abs(static_cast<double>(static_cast<long double>(w.one) - w1)),
                                                std::abs(static_cast<double>(static_cast<long double>(w.two) - w2))});
      most.depth = std::max(most.depth, std::abs(static_cast<double>(static_cast<long double>(shape.depth(x, y, s)) - depth)));
    }
  }
  return most;
}

TEST_CASE("contract: near weights err by 1.5 * 2^-23 at most, depths by 3 * 2^-23", "[reference]") {
  for (const int samples : {1, 4, 16}) {
    const LargestErrors most = errors_of_triangles(71, 900, samples);
    INFO("seed 71, " << samples << " samples: weight " << most.weight << ", depth " << most.depth);
    CHECK(most.weight <= 1.5 * 0x1p-23);
    CHECK(most.depth <= 3 * 0x1p-23);
  }
}

TEST_CASE("contract: far weights err by 1.5 * 2^-23 at most, depths by 3 * 2^-23", "[reference]") {
  for (const int samples : {1, 4, 16}) {
    const LargestErrors most = errors_of_triangles(72, 32000, samples);
    INFO("seed 72, " << samples << " samples: weight " << most.weight << ", depth " << most.depth);
    CHECK(most.weight <= 1.5 * 0x1p-23);
    CHECK(most.depth <= 3 * 0x1p-23);
  }
}

TEST_CASE("contract: so do those of triangles of some pixels", "[reference]") {
  const LargestErrors most = errors_of_triangles(73, 40, 1);
  INFO("seed 73: weight " << most.weight << ", depth " << most.depth);
  CHECK(most.weight <= 1.5 * 0x1p-23);
  CHECK(most.depth <= 3 * 0x1p-23);
}

}  // namespace
}  // namespace tuberia::oracle
