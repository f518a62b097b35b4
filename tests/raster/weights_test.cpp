#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/coverage.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/triangles.hpp"

namespace tuberia {

using test::for_every_machine;
using test::Triangle;

namespace {

/// The largest difference between a weight at a covered centre and the quotient of areas it stands for.
/// Divided by 1 and what the weight changes over some pixels.
double worst_weight(const std::vector<Triangle>& triangles, int size, InstructionSet set, Precision precision, double pixels = 0) {
  double worst = 0;
  const test::TriangleSet screen(triangles, size, size, set, test::kEverything);
  screen.for_each_block(block_kernels(set, precision), [&](const FragmentBlock& block) {
    const ScreenTriangle& t = *block.triangle;
    SnappedPoint v[3];
    for (std::size_t k = 0; k < 3; ++k) v[k] = triangles[t.primitive][t.vertex[k] % 3u];
    const auto area = static_cast<double>(twice_area(v[0], v[1], v[2]));
    for (int i = 0; i < kBlockPixels; ++i) {
      if ((block.live >> i & 1u) == 0) continue;
      const SnappedPoint centre{(block.left + block_x(i)) * 256 + 128, (block.top + block_y(i)) * 256 + 128};
      const double right[2] = {static_cast<double>(twice_area(v[0], centre, v[2])) / area, static_cast<double>(twice_area(v[0], v[1], centre)) / area};
      for (int k = 0; k < 2; ++k) {
        const double change = 256 * (std::abs(static_cast<double>(t.per_x[k + 1])) + std::abs(static_cast<double>(t.per_y[k + 1]))) / area;
        worst = std::max(worst, std::abs(static_cast<double>(block.weight[k][i]) - right[k]) / (1 + pixels * change));
      }
    }
  });
  return worst;
}

/// Those at least `height` pixels high above their longest side, so that weights do not change much
/// from pixel to pixel.
std::vector<Triangle> not_thinner_than(double height, std::vector<Triangle> triangles) {
  std::erase_if(triangles, [&](const Triangle& t) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, std::hypot(static_cast<double>(t[k].x - t[(k + 1) % 3].x), static_cast<double>(t[k].y - t[(k + 1) % 3].y)));
    return static_cast<double>(std::abs(twice_area(t[0], t[1], t[2]))) < height * 256 * longest;
  });
  return triangles;
}

}  // namespace

TEST_CASE("weights: small triangles' are within 2e-7 of the quotients of areas", "[raster]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    CHECK(worst_weight(test::small_triangles(111, 20000, 200, 200), 200, set, precision) <= 2e-7);
    CHECK(worst_weight(test::random_triangles(112, 200, -10000, 70000), 256, set, precision) <= 2e-7);
    CHECK(worst_weight(test::slivers(113, 2000, 60000), 256, set, precision) <= 2e-7);
  });
}

TEST_CASE("weights: those of triangles beyond the near span are as good unless they are thin", "[raster]") {
  // Corners more than 1984 pixels apart take planes anchored to the pixel grid.
  const auto large = not_thinner_than(64, test::random_triangles(114, 12, -300000, 900000));
  const auto huge = not_thinner_than(64, test::random_triangles(115, 12, -8388608, 8388608));
  for_every_machine([&](InstructionSet set, Precision precision) {
    CHECK(worst_weight(large, 2048, set, precision) <= 5e-7);
    CHECK(worst_weight(huge, 2048, set, precision) <= 5e-7);
  });
}

// Where a weight runs through its whole range in less than a pixel, its plane's roundings show; by
// far less than the snap has moved the edges.
TEST_CASE("weights: those of thin ones beyond the near span are off by little of what 64 pixels change", "[raster]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    CHECK(worst_weight(test::slivers(116, 3000, 2000000), 256, set, precision, 64) <= 2e-7);
  });
}

}  // namespace tuberia
