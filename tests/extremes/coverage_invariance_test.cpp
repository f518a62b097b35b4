// What coverage does not depend on: rules R2, R5 and R6, cases 13 to 15.

#include <catch2/catch.hpp>

#include "tests/support/drawn_coverage.hpp"
#include "tests/support/triangles.hpp"

namespace tuberia {

using test::Coverage;
using test::covered;
using test::Triangle;

namespace {

void check_against_definition(const std::vector<Triangle>& triangles, int width, int height) {
  const Coverage definition = test::covered_by_definition(triangles, width, height);
  for (const InstructionSet set : supported_instruction_sets())
    for (const Precision precision : {Precision::exact, Precision::fast}) {
      INFO("instruction set " << name_of(set) << ", precision " << static_cast<int>(precision));
      CHECK(covered(triangles, width, height, set, test::kEverything, precision) == definition);
    }
}

}  // namespace

TEST_CASE("coverage: every instruction set and precision obeys the definition", "[extremes][R2]") {
  SECTION("of the target's size, seed 21") { check_against_definition(test::random_triangles(21, 400, -20000, 90000), 250, 190); }
  SECTION("a few pixels, seed 22") { check_against_definition(test::small_triangles(22, 20000, 200, 130), 200, 130); }
  SECTION("slivers across the target, seed 23") { check_against_definition(test::slivers(23, 3000, 70000), 256, 256); }
  SECTION("slivers across the guard band, seed 24") { check_against_definition(test::slivers(24, 3000, 8000000), 256, 256); }
  SECTION("across the guard band, seed 25") { check_against_definition(test::random_triangles(25, 400, -8388608, 8388609), 200, 200); }
  SECTION("just below and just above the near span, seed 26") {
    check_against_definition(test::random_triangles(26, 60, -1000, 512000), 2048, 300);
  }
}

TEST_CASE("coverage: the corners of the guard band are part of it", "[extremes][R2]") {
  constexpr std::int32_t kEnd = kGuardBandUnits;
  check_against_definition({{SnappedPoint{-kEnd, -kEnd}, {kEnd, -kEnd}, {-kEnd, kEnd}},
                            {SnappedPoint{kEnd, kEnd}, {-kEnd, kEnd}, {kEnd, -kEnd}},
                            {SnappedPoint{-kEnd, kEnd}, {kEnd, -kEnd}, {kEnd, -kEnd + 1}},
                            {SnappedPoint{kEnd, -kEnd}, {-kEnd, kEnd}, {-kEnd, kEnd - 1}}},
                           100, 70);
}

TEST_CASE("coverage: it matters neither where a triangle begins nor how it turns", "[extremes][R6][case-14]") {
  const auto triangles = test::random_triangles(1, 2000, 0, 65536);
  for (const InstructionSet set : supported_instruction_sets()) {
    INFO("instruction set " << name_of(set));
    for (const auto& order : {std::array<std::size_t, 3>{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}) {
      std::vector<Triangle> turned;
      for (const Triangle& t : triangles) turned.push_back({t[order[0]], t[order[1]], t[order[2]]});
      const Coverage coverage = covered(turned, 256, 256, set);
      CHECK(coverage.hash == 0x13687ddb2cf21);
      CHECK(coverage.count == 10115389);
    }
  }
}

TEST_CASE("coverage: four scissored quadrants make the whole", "[extremes][R6][case-13]") {
  const auto triangles = test::random_triangles(1, 2000, 0, 65536);
  for (const InstructionSet set : supported_instruction_sets()) {
    INFO("instruction set " << name_of(set));
    // Cuts inside blocks, and of odd widths, to meet the edges of registers, too.
    for (const auto& [x, y] : {std::pair{128, 128}, {101, 35}, {1, 255}}) {
      Coverage sum(256, 256, triangles.size());
      for (const PixelRect& part : {PixelRect{0, 0, x, y}, {x, 0, 256, y}, {0, y, x, 256}, {x, y, 256, 256}}) {
        const Coverage quadrant = covered(triangles, 256, 256, set, part);
        for (int i = 0; i < 256 * 256; ++i)
          if (quadrant.owners[static_cast<std::size_t>(i)] > 0) {
            const int column = i % 256, row = i / 256;
            const bool inside = column >= part.left && column < part.right && row >= part.top && row < part.bottom;
            if (!inside) FAIL("pixel " << column << ", " << row << " lies outside the scissor");
          }
        sum += quadrant;
      }
      CHECK(sum.count == 10115389);
      CHECK(sum.hash == 0x13687ddb2cf21);
    }
  }
}

TEST_CASE("coverage: threads and scissored quadrants change nothing in the whole pipeline", "[extremes][R6][case-13]") {
  const auto triangles = test::random_triangles(1, 2000, 0, 65536);
  const test::PublishedCoverage right{10115389, 0x13687ddb2cf21};
  for (const InstructionSet set : supported_instruction_sets())
    for (const int threads : {1, 2, 3, 7, 16}) {
      INFO(name_of(set) << ", " << threads << " threads, tiles of " << kTileSize);
      const PipelineOptions options{.threads = threads, .instruction_set = set};
      CHECK(test::published(test::drawn_sums(triangles, 256, 256, options)) == right);
      test::PublishedCoverage sum;
      PipelineState state = test::adding();
      for (const PixelRect& part : {PixelRect{0, 0, 101, 35}, {101, 0, 256, 35}, {0, 35, 101, 256}, {101, 35, 256, 256}}) {
        state.rasterization.scissor = part;
        const test::PublishedCoverage quadrant = test::published(test::drawn_sums(triangles, 256, 256, options, state));
        sum = {sum.count + quadrant.count, sum.hash + quadrant.hash};
      }
      CHECK(sum == right);
    }
}

TEST_CASE("coverage: formats, depth and blending decide nothing about it", "[extremes][R6][case-10]") {
  // Every way to draw small triangles onto black leaves the pixels that the definition names.
  const auto triangles = test::small_triangles(3, 20000, 128, 128);
  const Coverage definition = test::covered_by_definition(triangles, 128, 128);
  const auto vertices = test::screen_vertices(triangles);
  const auto check = [&](const test::Canvas& canvas, const PipelineState& state) {
    test::Studio studio(canvas);
    studio.draw({.screen_positions = vertices}, flat(), state);
    const Image<Rgba8> image = studio.target().colour_image();
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x)
        if ((image.at(x, y).r != 0) != (definition.owners_at(x, y) > 0)) FAIL("pixel " << x << ", " << y);
  };
  for (const InstructionSet set : supported_instruction_sets())
    for (const ColourFormat colour : {ColourFormat::rgba8, ColourFormat::srgb8, ColourFormat::rgba16f, ColourFormat::rgba32f})
      for (const DepthFormat depth : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f})
        for (const DepthState& tested : {kDepthOff, DepthState{}, DepthState{.test = Compare::less_equal, .write = false}})
          for (const BlendMode mode : {BlendMode::replace, BlendMode::source_over, BlendMode::additive, BlendMode::function}) {
            INFO(name_of(set) << ", colour format " << static_cast<int>(colour) << ", depth format " << static_cast<int>(depth) << ", blend mode " << static_cast<int>(mode));
            PipelineState state;
            state.depth = tested;
            state.blend.mode = mode;
            check({.width = 128, .height = 128, .colour = colour, .depth = depth, .options = {.threads = 2, .instruction_set = set}}, state);
          }
}

TEST_CASE("coverage: moving by whole pixels moves the pixels", "[extremes][R6]") {
  const auto triangles = test::random_triangles(31, 300, 0, 16384);
  const Coverage still = covered(triangles, 64, 64, InstructionSet::baseline);
  for (const InstructionSet set : supported_instruction_sets()) {
    std::vector<Triangle> moved = triangles;
    for (Triangle& t : moved)
      for (SnappedPoint& p : t) p = {p.x + 71 * 256, p.y + 13 * 256};
    const Coverage there = covered(moved, 135, 77, set);
    CHECK(there.pixels_of == still.pixels_of);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x)
        if (there.owners_at(x + 71, y + 13) != still.owners_at(x, y)) FAIL("pixel " << x << ", " << y);
  }
}

TEST_CASE("coverage: odd targets lose and invent no pixel", "[extremes][R5][case-15]") {
  const Triangle all{SnappedPoint{-256, -256}, {kGuardBandUnits, -256}, {-256, kGuardBandUnits}};
  const std::vector<std::pair<int, int>> sizes{{1, 1}, {1, 37}, {37, 1}, {16384, 1}, {1, 16384}, {65, 63}};
  for (const InstructionSet set : supported_instruction_sets())
    for (const auto& [width, height] : sizes) {
      INFO(name_of(set) << ", " << width << "x" << height);
      const Coverage coverage = covered({&all, 1}, width, height, set);
      CHECK(coverage.count == static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height));
      CHECK(coverage.most_owners() == 1);
    }
}

}  // namespace tuberia
