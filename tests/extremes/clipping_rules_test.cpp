// What the whole pipeline promises of clipped triangles: rules C1 to C3, C5 and C7.

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/drawn_coverage.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/triangles.hpp"

namespace tuberia {

using test::for_every_instruction_set;
using test::Studio;

namespace {

/// Any sign, any size up to the largest that is promised to be safe, FLT_MAX / 16.
float promised_coordinate(test::Random& random) {
  const int exponent = static_cast<int>(random.below(249)) - 126;
  const float size = std::ldexp(random.between(1, 2), exponent);
  return std::min(size, std::numeric_limits<float>::max() / 16) * (random.below(2) == 0 ? 1.0f : -1.0f);
}

std::vector<glm::vec4> random_clip_positions(test::Random& random, int count) {
  std::vector<glm::vec4> positions;
  for (int i = 0; i < count; ++i) positions.push_back({random.between(-3, 3), random.between(-3, 3), random.between(-2, 2), random.between(-1, 2)});
  return positions;
}

}  // namespace

TEST_CASE("clipping rules: positions up to FLT_MAX / 16 give numbers and nothing else", "[extremes][C1]") {
  test::Random random(0xc1);
  for_every_instruction_set([&](InstructionSet set) {
    Studio studio({.width = 40, .height = 30, .colour = ColourFormat::rgba32f, .depth = DepthFormat::d32f, .options = {.threads = 1, .instruction_set = set}});
    PipelineState state;
    state.depth.test = Compare::always;
    for (int i = 0; i < 400; ++i) {
      std::vector<glm::vec4> positions, colours;
      for (int k = 0; k < 30; ++k) {
        positions.push_back({promised_coordinate(random), promised_coordinate(random), promised_coordinate(random), promised_coordinate(random)});
        colours.push_back({random.between(0, 1), random.between(0, 1), random.between(0, 1), 1});
      }
      state.clipping.volume = i % 2 == 0 ? ClipVolume::minus_w_to_w : ClipVolume::zero_to_w;
      studio.draw({.clip_positions = positions, .colours = colours}, gouraud(), state);
    }
    INFO("seed 0xc1");
    int drawn = 0;
    const Image<Rgba32F> image = studio.target().linear_image();
    for (const Rgba32F& p : image.pixels()) {
      drawn += p.a != 0;
      for (const float channel : {p.r, p.g, p.b})
        if (!(channel >= -0x1p-22f && channel <= 1 + 0x1p-22f)) FAIL("a colour of " << channel);
    }
    CHECK(drawn > 600);
    const Image<float> depths = studio.target().depth_image();
    for (const float depth : depths.pixels())
      if (!(depth >= 0 && depth <= 1)) FAIL("a depth of " << depth);
  });
}

TEST_CASE("clipping rules: a shared edge that is cut owns each pixel once", "[extremes][C2][R3][case-23]") {
  // Quadrilaterals in the plane of three random points, each cut along a diagonal, many through the
  // near plane: what the two halves cover together is what the halves of the other diagonal do, but
  // for pixels next to the outline, and none twice.
  test::Random random(0xc2);
  int seen = 0;
  for (int i = 0; i < 400; ++i) {
    const auto corner = random_clip_positions(random, 3);
    const glm::vec4 a = corner[0], b = corner[1], d = corner[2];
    const float s = random.between(0.3f, 1), t = random.between(0.3f, 1);
    const glm::vec4 c = a * (1 - s - t) + b * s + d * t;
    if (s + t < 1) continue;
    const std::vector<glm::vec4> positions{a, b, c, c, d, a};
    const auto colours = test::numbers_as_colours(2);
    Studio studio({.width = 64, .height = 48, .colour = ColourFormat::rgba32f});
    studio.draw({.clip_positions = positions, .colours = colours}, flat(), test::adding());
    INFO("seed 0xc2, quadrilateral " << i);
    const Image<Rgba32F> sums = studio.target().linear_image();
    for (const Rgba32F& sum : sums.pixels()) {
      if (sum.g > 1) FAIL("a pixel is covered " << sum.g << " times");
      seen += sum.g > 0;
    }
  }
  CHECK(seen > 50000);
}

TEST_CASE("clipping rules: scaling all of a triangle by a power of two changes no bit", "[extremes][C3][case-24]") {
  test::Random random(0xc3);
  for (int i = 0; i < 150; ++i) {
    const auto positions = random_clip_positions(random, 3);
    const std::vector<glm::vec4> colours{{1, 0, 0.5f, 1}, {0, 1, 0.25f, 1}, {0.75f, 0.5f, 1, 1}};
    const auto digest = [&](float scale) {
      std::vector<glm::vec4> scaled;
      for (const glm::vec4& p : positions) scaled.push_back(p * scale);
      Studio studio({.width = 64, .height = 48, .colour = ColourFormat::rgba32f, .depth = DepthFormat::d32f});
      studio.draw({.clip_positions = scaled, .colours = colours}, gouraud());
      return studio.digest();
    };
    INFO("seed 0xc3, triangle " << i);
    const std::string once = digest(1);
    for (const float scale : {0x1p-20f, 0x1p20f, 0x1p-90f, 0x1p90f}) CHECK(digest(scale) == once);
  }
}

TEST_CASE("clipping rules: edges that the clipper made are not drawn as edges", "[extremes][C5]") {
  // Case 17: the near plane leaves (-.5,-.5) (.5,-.5) (.25,0) (-.25,0); the last edge is the cut.
  const std::vector<glm::vec4> positions{{-.5f, -.5f, .5f, 1}, {.5f, -.5f, .5f, 1}, {0, .5f, -.5f, 1}};
  PipelineState state;
  state.clipping.volume = ClipVolume::zero_to_w;
  state.rasterization.front_mode = state.rasterization.back_mode = PolygonMode::line;
  Studio studio({});
  studio.draw({.clip_positions = positions}, flat(), state);
  const Image<Rgba8> image = studio.target().colour_image();
  const auto is_drawn = [&](int x, int y) { return image.at(x, y).a != 0; };
  for (int x = 26; x < 38; ++x)
    for (int y = 31; y <= 33; ++y) CHECK_FALSE(is_drawn(x, y));
  int below = 0;
  for (int x = 17; x < 47; ++x) below += is_drawn(x, 47) || is_drawn(x, 48);
  CHECK(below == 30);
  for (int y = 33; y < 47; ++y) {
    const int inwards = (47 - y) / 2;
    CHECK((is_drawn(16 + inwards, y) || is_drawn(15 + inwards, y) || is_drawn(17 + inwards, y)));
    CHECK((is_drawn(47 - inwards, y) || is_drawn(46 - inwards, y) || is_drawn(48 - inwards, y)));
  }
}

TEST_CASE("clipping rules: what leaves the screen but not the guard band stays whole, and exact", "[extremes][C7][case-08]") {
  // The published sets as clip positions, each exactly representable. Clipped at the screen's border
  // instead, 23 pixels of the first 200 triangles of seed 7 would differ.
  for (const auto& [seed, low, high, count, hash] : {std::tuple{1ull, 0, 65536, 10115389ull, 0x13687ddb2cf21ull}, {7ull, -65536, 131072, 29544683ull, 0x36ce45a36b1cfull}}) {
    std::vector<glm::vec4> positions;
    for (const test::Triangle& triangle : test::random_triangles(seed, 2000, low, high))
      for (const SnappedPoint& p : triangle)
        positions.push_back({static_cast<float>(p.x) / 32768 - 1, 1 - static_cast<float>(p.y) / 32768, 0, 1});
    const auto colours = test::numbers_as_colours(2000);
    const test::PublishedCoverage expected{count, hash};
    for_every_instruction_set([&](InstructionSet set) {
      Studio studio({.width = 256, .height = 256, .colour = ColourFormat::rgba32f, .options = {.threads = 3, .instruction_set = set}});
      const DrawStatistics drawn = studio.draw({.clip_positions = positions, .colours = colours}, flat(), test::adding());
      CHECK(drawn.triangles_clipped == 0);
      CHECK((test::published(studio.target().linear_image()) == expected));
    });
  }
}

TEST_CASE("clipping rules: what leaves the guard band is cut, and covers the screen as before", "[extremes][C7][C6]") {
  for_every_instruction_set([](InstructionSet set) {
    for (const float reach : {1000.0f, 1e5f, 1e20f}) {
      const std::vector<glm::vec4> positions{{-reach, -reach, 0, 1}, {3 * reach, -reach, 0, 1}, {-reach, 3 * reach, 0, 1}};
      Studio studio({.width = 64, .height = 64, .options = {.threads = 1, .instruction_set = set}});
      const DrawStatistics drawn = studio.draw({.clip_positions = positions}, flat());
      CHECK(drawn.triangles_clipped == 1);
      CHECK(test::pixels_drawn(studio.target().colour_image()) == 64 * 64);
    }
  });
}

}  // namespace tuberia
