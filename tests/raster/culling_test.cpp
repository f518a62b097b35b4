#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/triangles.hpp"

namespace tuberia {

using test::for_every_instruction_set;
using test::Triangle;

namespace {

/// How many columns and rows of a target's pixels have their centres within a triangle's bounds.
struct CentresWithin {
  int columns, rows;

  CentresWithin(const Triangle& t, int width, int height) {
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
    const auto count = [](int low, int high, int end) {
      int found = 0;
      for (int i = 0; i < end; ++i) found += low <= 256 * i + 128 && 256 * i + 128 <= high;
      return found;
    };
    columns = count(left, right, width);
    rows = count(top, bottom, height);
  }
  bool any() const { return columns > 0 && rows > 0; }
};

struct Culled {
  std::vector<bool> is_kept;
  int uncovered;
};

Culled culled(const std::vector<Triangle>& triangles, int width, int height, InstructionSet set, int margin_pixels = 0) {
  std::vector<ScreenVertex> vertices(3 * triangles.size() + kKernelPadding);
  std::vector<std::uint32_t> v[5];
  for (auto& array : v) array.resize(triangles.size() + kKernelPadding, 0u);
  std::vector<std::uint8_t> is_back(triangles.size() + kKernelPadding);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      vertices[3 * i + k] = {triangles[i][k].x, triangles[i][k].y, 0, 1};
      v[k][i] = static_cast<std::uint32_t>(3 * i + k);
    }
    v[4][i] = static_cast<std::uint32_t>(i);
  }
  const CullResult result = geometry_kernels(set).cull({v[0].data(), v[1].data(), v[2].data(), v[3].data(), v[4].data(), is_back.data()},
                                                       static_cast<int>(triangles.size()), vertices.data(),
                                                       {.margin_pixels = margin_pixels}, {0, 0, width, height});
  Culled all{std::vector<bool>(triangles.size()), result.uncovered};
  for (std::size_t i = 0; i < static_cast<std::size_t>(result.kept); ++i) all.is_kept[v[4][i]] = true;
  return all;
}

/// Corners up to `reach` units from a place on the target; often on a centre, or level with one.
std::vector<Triangle> near_centres(std::uint64_t seed, int count, int reach, int width, int height) {
  test::Random random(seed);
  std::vector<Triangle> triangles(static_cast<std::size_t>(count));
  for (Triangle& t : triangles) {
    const std::int64_t x = random.below(width * 256 + 512) - 256, y = random.below(height * 256 + 512) - 256;
    const auto place = [&](std::int64_t middle) {
      const std::int64_t at = middle + random.below(2 * reach + 1) - reach;
      return static_cast<std::int32_t>(random.below(3) == 0 ? (at & ~255) + 128 : at);
    };
    for (SnappedPoint& p : t) p.x = place(x), p.y = place(y);
  }
  return triangles;
}

}  // namespace

TEST_CASE("culling: of small triangles with centres in their bounds, those that cover none go", "[raster][exact]") {
  constexpr int kWidth = 40, kHeight = 30;
  for (const int reach : {60, 130, 260, 400, 20000}) {
    const std::vector<Triangle> triangles = near_centres(110 + static_cast<std::uint64_t>(reach), 20000, reach, kWidth, kHeight);
    const test::Coverage definition = test::covered_by_definition(triangles, kWidth, kHeight);
    for_every_instruction_set([&](InstructionSet set) {
      const Culled result = culled(triangles, kWidth, kHeight, set);
      int dropped = 0;
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        const CentresWithin centres(triangles[i], kWidth, kHeight);
        const bool counts = centres.any() && twice_area(triangles[i][0], triangles[i][1], triangles[i][2]) != 0;
        const bool covers = definition.pixels_of[i] > 0;
        dropped += counts && !result.is_kept[i];
        if (covers && !result.is_kept[i]) FAIL("reach " << reach << ": triangle " << i << " covers a centre and was dropped");
        if (!counts && result.is_kept[i]) FAIL("reach " << reach << ": triangle " << i << " has no area or no centre and was kept");
        if (counts && !covers && centres.columns <= 2 && centres.rows <= 2 && reach < 20000 && result.is_kept[i])
          FAIL("reach " << reach << ": triangle " << i << " covers no centre and was kept");
      }
      CHECK(result.uncovered == dropped);
      if (reach < 20000) CHECK(dropped > 1000);
    });
  }
}

TEST_CASE("culling: where samples may lie beside the centres, small triangles stay", "[raster]") {
  const std::vector<Triangle> triangles = near_centres(120, 2000, 200, 40, 30);
  for_every_instruction_set([&](InstructionSet set) {
    const Culled result = culled(triangles, 40, 30, set, 1);
    CHECK(result.uncovered == 0);
    for (std::size_t i = 0; i < triangles.size(); ++i)
      if (CentresWithin(triangles[i], 40, 30).any() && twice_area(triangles[i][0], triangles[i][1], triangles[i][2]) != 0) CHECK(result.is_kept[i]);
  });
}

}  // namespace tuberia
