// Edge functions in 64 bits everywhere, and in floats: which pixels they give up.

#include <catch2/catch.hpp>

#include <bitset>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/triangles.hpp"

namespace tuberia {

using test::Triangle;

namespace {

test::Coverage covered_with(EdgeArithmetic edges, std::span<const Triangle> triangles, int width, int height, InstructionSet set,
                            const PixelRect& clip = test::kEverything, Precision precision = Precision::exact) {
  return test::covered(triangles, width, height, set, clip, precision, edges);
}

constexpr int kWindow = 128;
using Pixels = std::bitset<kWindow * kWindow>;

/// The pixels of each triangle in a square window of the target.
std::vector<Pixels> pixels_of(EdgeArithmetic edges, std::span<const Triangle> triangles, int first) {
  std::vector<Pixels> owned(triangles.size());
  const int size = first + kWindow;
  const test::TriangleSet set(triangles, size, size, best_instruction_set(), {first, first, size, size}, {}, {}, edges);
  set.for_each_block(block_kernels(best_instruction_set(), Precision::exact), [&](const FragmentBlock& block) {
    for (int i = 0; i < kBlockPixels; ++i)
      if ((block.live >> i & 1u) != 0)
        owned[block.triangle->primitive].set(static_cast<std::size_t>((block.top + block_y(i) - first) * kWindow + block.left + block_x(i) - first));
  });
  return owned;
}

/// Triangles of up to `reach` pixels, each moved so that the middle of an edge lies in the middle.
std::vector<Triangle> triangles_about_an_edge(std::int64_t reach) {
  std::vector<Triangle> triangles = test::random_triangles(17, 4000, 0, 256 * reach);
  const auto middle = static_cast<std::int32_t>(reach / 2 * 256);
  for (Triangle& t : triangles) {
    const std::int32_t right = middle - (t[0].x + t[1].x) / 2, down = middle - (t[0].y + t[1].y) / 2;
    for (SnappedPoint& p : t) p = {p.x + right, p.y + down};
  }
  return triangles;
}

/// Pixels that change hands for every million that lie along an edge, of triangles as large as `reach` pixels.
double wrong_in_a_million(EdgeArithmetic edges, std::int64_t reach) {
  const auto triangles = triangles_about_an_edge(reach);
  const int first = static_cast<int>(reach / 2) - kWindow / 2;
  const auto found = pixels_of(edges, triangles, first), right = pixels_of(EdgeArithmetic::exact, triangles, first);
  double wrong = 0, along_edges = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    wrong += static_cast<double>((found[i] ^ right[i]).count());
    Pixels inner;  // of the window, without its last row and column
    for (std::size_t y = 0; y + 1 < kWindow; ++y)
      for (std::size_t x = 0; x + 1 < kWindow; ++x) inner.set(y * kWindow + x);
    along_edges += static_cast<double>((((right[i] ^ right[i] >> 1) | (right[i] ^ right[i] >> kWindow)) & inner).count());
  }
  return 1e6 * wrong / along_edges;
}

}  // namespace

TEST_CASE("edges: 64 bits everywhere cover what the usual arithmetic does", "[raster][exact][case-08][case-09]") {
  const auto large = test::random_triangles(7, 2000, -65536, 131072), huge = test::random_triangles(5, 500, -8388608, 8388607);
  const auto small = test::small_triangles(3, 20000, 128, 128), thin = test::slivers(9, 500, 1 << 20);
  test::for_every_instruction_set([&](InstructionSet set) {
    CHECK(covered_with(EdgeArithmetic::exact_64, large, 256, 256, set).hash == 0x36ce45a36b1cf);
    CHECK(covered_with(EdgeArithmetic::exact_64, huge, 128, 96, set).hash == 0x1ae06591e68);
    CHECK(covered_with(EdgeArithmetic::exact_64, small, 128, 128, set).hash == 0x9d80d3a256);
    CHECK(covered_with(EdgeArithmetic::exact_64, thin, 256, 256, set) == test::covered(thin, 256, 256, set));
  });
}

// Where an edge crosses a square of 64 pixels its function there is at most 63 (|per_x| + |per_y|), for
// edges up to 512 pixels long below 2^24: floats hold that.
TEST_CASE("edges: floats anchored at squares are exact for edges up to 512 pixels", "[raster][exact][case-08][case-10]") {
  const auto medium = test::random_triangles(1, 2000, 0, 65536), small = test::small_triangles(3, 20000, 128, 128);
  const auto mesh = test::jittered_mesh();
  test::for_every_instruction_set([&](InstructionSet set) {
    const auto found = covered_with(EdgeArithmetic::float_anchored, medium, 256, 256, set);
    CHECK(found.count == 10115389);
    CHECK(found.hash == 0x13687ddb2cf21);
    CHECK(covered_with(EdgeArithmetic::float_anchored, small, 128, 128, set).hash == 0x9d80d3a256);
    CHECK(covered_with(EdgeArithmetic::float_anchored, mesh, 128, 96, set).hash == 0x50081fb9f);
  });
}

// A plane's constant grows with the square of the size, and so does what is rounded off it.
TEST_CASE("edges: float planes err ten times as often as anchored floats", "[raster][trade]") {
  const double plane = wrong_in_a_million(EdgeArithmetic::float_plane, 4096);
  const double anchored = wrong_in_a_million(EdgeArithmetic::float_anchored, 4096);
  CAPTURE(plane, anchored);
  CHECK((plane > 60 && plane < 600));
  CHECK(anchored < plane / 10);
}

TEST_CASE("edges: floats cover the same on every machine and in both precisions", "[raster][exact]") {
  const auto huge = test::random_triangles(5, 500, -8388608, 8388607);
  for (const EdgeArithmetic edges : {EdgeArithmetic::float_anchored, EdgeArithmetic::float_plane}) {
    const auto first = covered_with(edges, huge, 128, 96, InstructionSet::baseline);
    CHECK(first.count > 1200000);
    test::for_every_instruction_set([&](InstructionSet set) {
      for (const Precision precision : {Precision::exact, Precision::fast})
        CHECK(covered_with(edges, huge, 128, 96, set, test::kEverything, precision) == first);
    });
  }
}

TEST_CASE("edges: what floats cover by mistake stays in the clip", "[raster][rules-R5]") {
  const auto huge = test::random_triangles(5, 500, -8388608, 8388607);
  const PixelRect clip{13, 7, 90, 51};
  test::for_every_instruction_set([&](InstructionSet set) {
    for (const EdgeArithmetic edges : {EdgeArithmetic::exact_64, EdgeArithmetic::float_anchored, EdgeArithmetic::float_plane}) {
      const auto found = covered_with(edges, huge, 128, 96, set, clip);
      std::uint32_t outside = 0;
      for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 128; ++x)
          if (x < clip.left || x >= clip.right || y < clip.top || y >= clip.bottom) outside += found.owners_at(x, y);
      CHECK(outside == 0);
      CHECK(found.count > 100000);
    }
  });
}

}  // namespace tuberia
