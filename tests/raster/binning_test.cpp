#include "raster/binning.hpp"

#include <catch2/catch.hpp>

#include "tests/support/coverage.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/triangles.hpp"

namespace tuberia {

namespace {

/// Whether each triangle is listed in each tile that has one of its pixels, and lists are in order.
void check_lists(const std::vector<test::Triangle>& triangles, int width, int height) {
  const test::TriangleSet set(triangles, width, height, best_instruction_set(), test::kEverything);
  std::vector<std::vector<bool>> listed(triangles.size(), std::vector<bool>(static_cast<std::size_t>(set.tile_count())));
  for (int tile = 0; tile < set.tile_count(); ++tile) {
    const auto list = set.lists().of_tile(tile);
    CHECK(std::is_sorted(list.begin(), list.end()));
    CHECK(std::adjacent_find(list.begin(), list.end()) == list.end());
    for (const std::uint16_t number : list) listed[set.screen_triangles()[number].primitive][static_cast<std::size_t>(tile)] = true;
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto owners = test::covered_by_definition({&triangles[i], 1}, width, height).owners;
    for (std::size_t pixel = 0; pixel < owners.size(); ++pixel) {
      if (owners[pixel] == 0) continue;
      const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
      const int tile = y / kTileSize * set.tiles_per_row() + x / kTileSize;
      if (!listed[i][static_cast<std::size_t>(tile)]) FAIL("triangle " << i << " is missing in tile " << tile);
    }
  }
}

std::size_t entries(const std::vector<test::Triangle>& triangles, int width, int height, const PixelRect& clip) {
  const test::TriangleSet set(triangles, width, height, InstructionSet::baseline, clip);
  std::size_t count = 0;
  for (int tile = 0; tile < set.tile_count(); ++tile) count += set.lists().of_tile(tile).size();
  return count;
}

}  // namespace

TEST_CASE("binning: every tile lists what touches it, once and in order", "[raster]") {
  SECTION("seed 101") { check_lists(test::random_triangles(101, 150, -30000, 90000), 300, 200); }
  SECTION("seed 102, small") { check_lists(test::small_triangles(102, 600, 300, 200), 300, 200); }
  SECTION("seed 103, slivers") { check_lists(test::slivers(103, 150, 80000), 300, 200); }
  SECTION("seed 104, guard band") { check_lists(test::random_triangles(104, 150, -8388608, 8388608), 300, 200); }
}

TEST_CASE("binning: a large triangle is not listed where its edges do not reach", "[raster]") {
  // Half of an 8x8-tile square: 36 of its 64 tiles, at most those that the diagonal touches more.
  const std::vector<test::Triangle> half{{SnappedPoint{0, 0}, {8 * 64 * 256, 0}, {0, 8 * 64 * 256}}};
  if (kTileSize == 64) CHECK(entries(half, 512, 512, test::kEverything) <= 43);
  if (kTileSize == 64) CHECK(entries(half, 512, 512, test::kEverything) >= 36);
}

TEST_CASE("binning: what lies outside the scissor is not listed", "[raster]") {
  const std::vector<test::Triangle> all{{SnappedPoint{-256, -256}, {400000, -256}, {-256, 400000}}};
  CHECK(entries(all, 512, 512, {70, 70, 75, 75}) == 1);
  CHECK(entries(all, 512, 512, {70, 70, 70, 75}) == 0);
}

}  // namespace tuberia
