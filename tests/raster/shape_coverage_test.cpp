#include "raster/shape_coverage.hpp"

#include <catch2/catch.hpp>

#include <map>

#include "math/edge_function.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

namespace {

__extension__ typedef __int128 BigInteger;

constexpr PixelRect kWholeTile{0, 0, kTileSize, kTileSize};

ScreenTriangle boundless_record() {
  ScreenTriangle record{};
  record.left = record.top = 0;
  record.right = record.bottom = kTileSize - 1;
  record.depth = 0.25f;
  record.depth_delta[0] = 0.5f;
  return record;
}

ScreenShape line_between(SnappedPoint a, SnappedPoint b, int size = kSubpixelUnits) {
  return {.kind = ScreenShape::Kind::line, .x = {a.x, b.x}, .y = {a.y, b.y}, .size = size};
}

ScreenShape point_at(SnappedPoint c, int size, bool round) {
  return {.kind = ScreenShape::Kind::point, .round = round, .x = {c.x}, .y = {c.y}, .size = size};
}

/// How often each sample of a tile was covered: key (y * kTileSize + x) * 16 + sample.
using Samples = std::map<int, int>;

Samples covered_samples(const ScreenShape& shape, int samples = 1, const StipplePattern& stipple = {}, const PixelRect& clip = kWholeTile) {
  const ScreenTriangle record = boundless_record();
  Tile tile;
  tile.samples = samples;
  std::vector<FragmentBlock> blocks;
  cover_shape(record, shape, stipple, tile, clip, blocks);
  Samples found;
  for (const FragmentBlock& block : blocks) {
    std::uint64_t any = 0;
    for (int s = 0; s < samples; ++s) {
      any |= block.sample_live[s];
      for (int i = 0; i < kBlockPixels; ++i)
        if ((block.sample_live[s] >> i & 1u) != 0) ++found[((block.top + block_y(i)) * kTileSize + block.left + block_x(i)) * 16 + s];
    }
    CHECK(any == block.live);
    CHECK(any != 0);
  }
  return found;
}

Samples sum_of(const Samples& a, const Samples& b) {
  Samples sum = a;
  for (const auto& [key, count] : b) sum[key] += count;
  return sum;
}

/// The definition, with a small number in place of the infinitely small one: on a lattice of 16
/// units and lines of a few pixels, 2^-16 units decide as anything smaller would.
struct Diamond {
  static constexpr BigInteger kOne = BigInteger{1} << 32, kShiftX = BigInteger{1} << 16, kShiftY = 1;
  BigInteger ax, ay, bx, by;

  Diamond(SnappedPoint a, SnappedPoint b, int px, int py) {
    const BigInteger cx = px * 256 + 128, cy = py * 256 + 128;
    ax = (a.x - cx) * kOne + kShiftX, ay = (a.y - cy) * kOne + kShiftY;
    bx = (b.x - cx) * kOne + kShiftX, by = (b.y - cy) * kOne + kShiftY;
  }
  static BigInteger magnitude(BigInteger v) { return v < 0 ? -v : v; }
  static bool holds(BigInteger x, BigInteger y) { return magnitude(x) + magnitude(y) < 128 * kOne; }
  /// Where the segment crosses the line on which `p` is 0: is the other coordinate there within the diamond?
  static bool crosses(BigInteger pa, BigInteger pb, BigInteger qa, BigInteger qb) {
    const BigInteger d = pb - pa;
    if (d == 0 || (pa < 0 && pb < 0) || (pa > 0 && pb > 0)) return false;
    return magnitude(qa * d - pa * (qb - qa)) < 128 * kOne * magnitude(d);
  }
  /// |x| + |y| is least at an end or where x or y is 0.
  bool is_met() const { return holds(ax, ay) || holds(bx, by) || crosses(ax, bx, ay, by) || crosses(ay, by, ax, bx); }
  bool is_left() const { return is_met() && !holds(bx, by); }
};

SnappedPoint lattice_point(test::Random& random, int step) {
  return {static_cast<std::int32_t>(random.below(12 * 256 / step) * step), static_cast<std::int32_t>(random.below(12 * 256 / step) * step)};
}

Samples line_by_definition(SnappedPoint a, SnappedPoint b, int width) {
  const bool x_major = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
  const int move = 128 * (width - 1);
  (x_major ? a.y : a.x) -= move;
  (x_major ? b.y : b.x) -= move;
  Samples found;
  for (int y = -width; y < 14; ++y)
    for (int x = -width; x < 14; ++x) {
      if (!Diamond(a, b, x, y).is_left()) continue;
      for (int i = 0; i < width; ++i) {
        const int at_x = x_major ? x : x + i, at_y = x_major ? y + i : y;
        if (at_x >= 0 && at_y >= 0) ++found[(at_y * kTileSize + at_x) * 16];
      }
    }
  return found;
}

}  // namespace

TEST_CASE("lines: a thin line draws the pixels whose diamonds it leaves", "[raster][exact]") {
  test::Random random(71);
  for (const int step : {128, 64, 16})
    for (int i = 0; i < 6000; ++i) {
      const SnappedPoint a = lattice_point(random, step), b = lattice_point(random, step);
      const int width = i % 3 == 0 ? 1 + static_cast<int>(random.below(4)) : 1;
      const bool same = covered_samples(line_between(a, b, width * 256)) == line_by_definition(a, b, width);
      if (!same) FAIL("seed 71, step " << step << ", line " << i << ": (" << a.x << ", " << a.y << ") to (" << b.x << ", " << b.y << "), width " << width);
    }
}

TEST_CASE("lines: very short ones draw a pixel only if they leave its diamond", "[raster][exact]") {
  test::Random random(72);
  for (int i = 0; i < 8000; ++i) {
    const SnappedPoint a = lattice_point(random, 32);
    const SnappedPoint b{a.x + static_cast<int>(random.below(13) - 6) * 32, a.y + static_cast<int>(random.below(13) - 6) * 32};
    const bool same = covered_samples(line_between(a, b)) == line_by_definition(a, b, 1);
    if (!same) FAIL("seed 72, line " << i << ": (" << a.x << ", " << a.y << ") to (" << b.x << ", " << b.y << ")");
  }
}

TEST_CASE("lines: cut in two anywhere a line draws the same pixels, each once", "[raster][exact]") {
  test::Random random(73);
  for (int i = 0; i < 3000; ++i) {
    const SnappedPoint a = lattice_point(random, 16);
    const int dx = static_cast<int>(random.below(201) - 100), dy = static_cast<int>(random.below(201) - 100);
    const int first = 1 + static_cast<int>(random.below(12)), second = 1 + static_cast<int>(random.below(12));
    const auto along = [&](int n) { return SnappedPoint{a.x + n * dx, a.y + n * dy}; };
    for (const int samples : {1, 8}) {
      const Samples whole = covered_samples(line_between(a, along(first + second), 300), samples);
      const Samples parts = sum_of(covered_samples(line_between(a, along(first), 300), samples),
                                   covered_samples(line_between(along(first), along(first + second), 300), samples));
      if (parts != whole) FAIL("seed 73, line " << i << ", " << samples << " samples");
    }
  }
}

TEST_CASE("lines: neighbouring rectangles share no sample and leave none out", "[raster][exact]") {
  // Along (3, 4) the side of a strip of 5 k units is (-4, 3) k away: all on the lattice.
  const SnappedPoint a{4000, 1100};
  for (const int k : {64, 77}) {
    const auto line = [&](int row) {
      const SnappedPoint from{a.x - 4 * k * row, a.y + 3 * k * row};
      return line_between(from, {from.x + 3 * 1000, from.y + 4 * 1000}, 5 * k);
    };
    Samples sum;
    std::size_t single = 0;
    for (int row = 0; row < 6; ++row) {
      const Samples one = covered_samples(line(row), 16);
      single += one.size();
      sum = sum_of(sum, one);
    }
    for (const auto& [key, count] : sum) CHECK(count == 1);
    CHECK(sum.size() == single);
    // 5000 units long and 30 k wide, 16 samples to 65536 square units.
    CHECK(static_cast<double>(sum.size()) == Approx(5000.0 * 30 * k * 16 / 65536).epsilon(0.01));
  }
}

TEST_CASE("points: a square of n pixels covers n times n of them wherever it lies", "[raster][exact]") {
  test::Random random(74);
  for (int i = 0; i < 500; ++i) {
    const int n = 1 + static_cast<int>(random.below(9));
    const SnappedPoint centre{3000 + static_cast<int>(random.below(3000)), 3000 + static_cast<int>(random.below(3000))};
    INFO("seed 74, point " << i);
    CHECK(covered_samples(point_at(centre, n * 256, false)).size() == static_cast<std::size_t>(n * n));
    // The right and lower borders are the next square's.
    const Samples next = covered_samples(point_at({centre.x + n * 256, centre.y}, n * 256, false), 4);
    for (const auto& [key, count] : sum_of(covered_samples(point_at(centre, n * 256, false), 4), next)) CHECK(count == 1);
  }
}

TEST_CASE("points: a disc covers what is nearer to its centre than its radius", "[raster][exact]") {
  test::Random random(75);
  for (int i = 0; i < 200; ++i) {
    const SnappedPoint centre{1000 + static_cast<int>(random.below(64)) * 64, 1000 + static_cast<int>(random.below(64)) * 64};
    const int size = 64 * (1 + static_cast<int>(random.below(40)));
    for (const int samples : {1, 4, 16}) {
      Samples expected;
      for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x < kTileSize; ++x)
          for (int s = 0; s < samples; ++s) {
            const SamplePosition at = sample_positions(samples)[static_cast<std::size_t>(s)];
            const double dx = 256 * x + 128 + 16 * at.x - centre.x, dy = 256 * y + 128 + 16 * at.y - centre.y;
            if (std::sqrt(dx * dx + dy * dy) < size / 2.0) expected[(y * kTileSize + x) * 16 + s] = 1;
          }
      if (covered_samples(point_at(centre, size, true), samples) != expected) FAIL("seed 75, disc " << i << ", " << samples << " samples");
    }
  }
}

TEST_CASE("lines: the stipple pattern counts pixels from the first end", "[raster][exact]") {
  const StipplePattern pattern{.bits = 0b0000'0000'0001'0011, .factor = 2};
  ScreenShape line = line_between({5 * 256 + 128, 256 + 128}, {60 * 256 + 128, 256 + 128});
  const auto columns = [&] {
    std::vector<int> found;
    for (const auto& [key, count] : covered_samples(line, 1, pattern)) found.push_back(key / 16 % kTileSize);
    return found;
  };
  CHECK(columns() == std::vector<int>{5, 6, 7, 8, 13, 14, 37, 38, 39, 40, 45, 46});
  line.stipple_start = 3;
  CHECK(columns() == std::vector<int>{5, 10, 11, 34, 35, 36, 37, 42, 43});
  std::swap(line.x[0], line.x[1]);
  line.stipple_start = 0;
  CHECK(columns() == std::vector<int>{19, 20, 25, 26, 27, 28, 51, 52, 57, 58, 59, 60});
}

TEST_CASE("lines: nothing outside the clip rectangle, everything inside", "[raster][exact]") {
  test::Random random(76);
  for (int i = 0; i < 500; ++i) {
    const PixelRect clip{static_cast<int>(random.below(6)), static_cast<int>(random.below(6)), 6 + static_cast<int>(random.below(6)), 6 + static_cast<int>(random.below(6))};
    const ScreenShape shape = i % 2 == 0 ? line_between(lattice_point(random, 8), lattice_point(random, 8), 512)
                                         : point_at(lattice_point(random, 8), 1024, i % 4 == 1);
    const int samples = i % 3 == 0 ? 4 : 1;
    Samples expected;
    for (const auto& [key, count] : covered_samples(shape, samples)) {
      const int x = key / 16 % kTileSize, y = key / 16 / kTileSize;
      if (x >= clip.left && x < clip.right && y >= clip.top && y < clip.bottom) expected[key] = count;
    }
    INFO("seed 76, shape " << i);
    CHECK(covered_samples(shape, samples, {}, clip) == expected);
  }
}

TEST_CASE("lines: weights and depths run from end to end", "[raster]") {
  const ScreenTriangle record = boundless_record();
  for (const bool upright : {false, true})
    for (const int samples : {1, 4}) {
      Tile tile;
      tile.samples = samples;
      ScreenShape line = line_between({1 * 256 + 128, 640}, {33 * 256 + 128, 640}, 512);
      if (upright) std::swap(line.x, line.y);
      std::vector<FragmentBlock> blocks;
      cover_shape(record, line, {}, tile, kWholeTile, blocks);
      REQUIRE(!blocks.empty());
      for (const FragmentBlock& block : blocks)
        for (int i = 0; i < kBlockPixels; ++i) {
          const int along = upright ? block.top + block_y(i) : block.left + block_x(i);
          CHECK(block.weight[0][i] == std::clamp(static_cast<float>(along - 1) / 32, 0.0f, 1.0f));
          CHECK(block.weight[1][i] == 0);
          for (int s = 0; s < samples; ++s) {
            const SamplePosition at = sample_positions(samples)[static_cast<std::size_t>(s)];
            const float sample_along = static_cast<float>(along - 1) + static_cast<float>(upright ? at.y : at.x) / 16;
            CHECK(block.depth_value[s][i] == Approx(0.25f + 0.5f * std::clamp(sample_along / 32, 0.0f, 1.0f)));
          }
        }
    }
}

}  // namespace tuberia
