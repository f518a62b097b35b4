// Coarser grids of vertices than 1/256 pixel: what they cost in pixels.

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"
#include "tests/support/triangles.hpp"

namespace tuberia {

using test::Triangle;

namespace {

struct RealPoint {
  double x, y;
};
using RealTriangle = std::array<RealPoint, 3>;

std::vector<RealTriangle> real_triangles(std::uint64_t seed, int count, int size) {
  test::Random random(seed);
  const auto coordinate = [&] { return static_cast<double>(random.below(size << 20)) * 0x1p-20; };
  std::vector<RealTriangle> triangles(static_cast<std::size_t>(count));
  for (RealTriangle& triangle : triangles)
    for (RealPoint& p : triangle) p = {coordinate(), coordinate()};
  return triangles;
}

double perimeter(const RealTriangle& t) {
  return std::hypot(t[1].x - t[0].x, t[1].y - t[0].y) + std::hypot(t[2].x - t[1].x, t[2].y - t[1].y) + std::hypot(t[0].x - t[2].x, t[0].y - t[2].y);
}

/// Which pixels of a square the triangle owns once its vertices are snapped.
std::vector<std::uint32_t> owned_when_snapped(const RealTriangle& real, int subpixel_bits, int size) {
  Triangle t;
  for (std::size_t k = 0; k < 3; ++k) t[k] = {snap(real[k].x, subpixel_bits), snap(real[k].y, subpixel_bits)};
  return test::covered({&t, 1}, size, size, best_instruction_set()).owners;
}

/// Pixels that change hands, for every 1000 pixels of edge.
double wrong_pixels(const std::vector<RealTriangle>& triangles, int subpixel_bits, int size) {
  double wrong = 0, length = 0;
  for (const RealTriangle& triangle : triangles) {
    const auto found = owned_when_snapped(triangle, subpixel_bits, size), finest = owned_when_snapped(triangle, kSubpixelBits, size);
    for (std::size_t i = 0; i < found.size(); ++i) wrong += found[i] != finest[i];
    length += perimeter(triangle);
  }
  return 1000 * wrong / length;
}

}  // namespace

TEST_CASE("snap: coarser grids round once, to nearest, ties to even", "[raster][exact]") {
  CHECK(snap(10.5, 0) == 10 * 256);
  CHECK(snap(11.5, 0) == 12 * 256);
  CHECK(snap(-0.5, 0) == 0);
  CHECK(snap(10.125, 2) == 10 * 256);
  CHECK(snap(10.375, 2) == 10 * 256 + 128);
  CHECK(snap(0.5009765625, 0) == 256);  // by way of 1/256 it would be a tie
  CHECK(snap(1e9, 3) == kGuardBandUnits);
  for (int bits = 0; bits <= kSubpixelBits; ++bits) CHECK(snap(-77.0, bits) == -77 * 256);
}

// An edge whose ends move by up to half a step each way moves by 0.19 steps on the average along it.
TEST_CASE("snap: each bit less doubles the pixels that change hands", "[raster][trade]") {
  const int size = 256;
  const auto triangles = real_triangles(21, 150, size);
  CHECK(wrong_pixels(triangles, 0, size) == Approx(190).epsilon(0.1));
  CHECK(wrong_pixels(triangles, 2, size) == Approx(48.5).epsilon(0.1));
  CHECK(wrong_pixels(triangles, 4, size) == Approx(12).epsilon(0.15));
  CHECK(wrong_pixels(triangles, 8, size) == 0);
}

}  // namespace tuberia
