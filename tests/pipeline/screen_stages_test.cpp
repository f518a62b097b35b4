#include <catch2/catch.hpp>

#include "math/edge_function.hpp"
#include "math/transforms.hpp"
#include "pipeline/culling.hpp"
#include "pipeline/perspective_divide.hpp"
#include "tests/support/batches.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

using test::for_every_instruction_set;

namespace {

struct Placed {
  std::int32_t x, y;
  float depth;
  bool operator==(const Placed&) const = default;
};

Placed divided(std::array<float, 4> clip, const ScreenMap& map, InstructionSet set) {
  VertexBatch batch = test::clip_batch({&clip, 1});
  PerspectiveDivide(map, set)(batch);
  return {batch.screen[0].x, batch.screen[0].y, batch.screen[0].depth};
}

/// Which of some triangles survive, by their primitives' numbers.
std::vector<std::uint32_t> survivors(const CullingState& state, const PixelRect& clip, VertexBatch& vertices,
                                     const std::vector<std::array<std::uint32_t, 3>>& corners, InstructionSet set) {
  TriangleBatch triangles;
  for (std::size_t i = 0; i < corners.size(); ++i)
    triangles.add(corners[i][0], corners[i][1], corners[i][2], corners[i][0], static_cast<std::uint32_t>(i));
  Culling(state, clip, set)(vertices, triangles);
  return {triangles.primitive.begin(), triangles.primitive.begin() + triangles.count};
}

}  // namespace

TEST_CASE("divide: the screen is snapped to nearest, ties to even", "[pipeline][exact][case-06]") {
  // A map that keeps ndc as pixels; y is flipped, and back.
  const ScreenMap pixels{.x_scale = 1, .x_offset = 0, .y_scale = 1, .y_offset = 0, .depth_scale = 1, .depth_offset = 0};
  for_every_instruction_set([&](InstructionSet set) {
    const auto x = [&](float ndc) { return divided({ndc, -ndc, 0, 1}, pixels, set).x; };
    CHECK(x(10.001953125f) == 2560);
    CHECK(x(10.005859375f) == 2562);
    CHECK(x(-10.001953125f) == -2560);
    CHECK(x(-10.005859375f) == -2562);
    CHECK(x(255.998046875f) == 65536);
    CHECK(x(0.001953125f) == 0);
    CHECK(divided({1, -10.005859375f, 0, 1}, pixels, set).y == -2562);
  });
}

TEST_CASE("divide: the wide snap is the scalar one, on every grid", "[pipeline][exact]") {
  for_every_instruction_set([&](InstructionSet set) {
    test::Random random(5);
    for (int bits = 0; bits <= kSubpixelBits; ++bits) {
      const ScreenMap pixels{.x_scale = 1, .x_offset = 0, .y_scale = 1, .y_offset = 0, .depth_scale = 1, .depth_offset = 0, .subpixel_bits = bits};
      for (int i = 0; i < 100; ++i) {
        const float x = static_cast<float>(random.below(1 << 16) - (1 << 15)) / 512, y = random.between(-40000, 40000);
        const Placed at = divided({x, y, 0, 1}, pixels, set);
        CHECK((at.x == snap(static_cast<double>(x), bits) && at.y == snap(static_cast<double>(y), bits)));
        CHECK((at.x % (256 >> bits) == 0 && at.y % (256 >> bits) == 0));
      }
    }
  });
}

// notes 15.3, in our frame: corners of pixels are whole numbers, and y runs down.
TEST_CASE("divide: ndc -1..1 is the viewport, wherever it lies", "[pipeline]") {
  for_every_instruction_set([&](InstructionSet set) {
    const ScreenMap map = screen_map({0, 0, 640, 480}, {}, ClipVolume::minus_w_to_w);
    CHECK(divided({-1, -1, -1, 1}, map, set) == Placed{0, 480 * 256, 0});
    CHECK(divided({0, 0, 0, 1}, map, set) == Placed{320 * 256, 240 * 256, 0.5f});
    CHECK(divided({1, 1, 1, 1}, map, set) == Placed{640 * 256, 0, 1});
    const ScreenMap moved = screen_map({-7, 5, 10, 20}, {}, ClipVolume::minus_w_to_w);
    CHECK(divided({-1, 1, 0, 1}, moved, set) == Placed{-7 * 256, 5 * 256, 0.5f});
    CHECK(divided({3, -3, 0, 3}, moved, set) == Placed{3 * 256, 25 * 256, 0.5f});
  });
}

TEST_CASE("divide: both ends of z meet the ends of the depth range", "[pipeline]") {
  for_every_instruction_set([&](InstructionSet set) {
    const Viewport viewport{0, 0, 64, 64};
    for (const DepthRange& range : {DepthRange{0, 1}, {1, 0}, {0.25f, 0.75f}, {0.5f, 0.5f}}) {
      const ScreenMap gl = screen_map(viewport, range, ClipVolume::minus_w_to_w), d3d = screen_map(viewport, range, ClipVolume::zero_to_w);
      CHECK(divided({0, 0, -2, 2}, gl, set).depth == range.near_depth);
      CHECK(divided({0, 0, 2, 2}, gl, set).depth == range.far_depth);
      CHECK(divided({0, 0, 0, 2}, d3d, set).depth == range.near_depth);
      CHECK(divided({0, 0, 2, 2}, d3d, set).depth == range.far_depth);
    }
  });
}

// notes 15.2
TEST_CASE("divide: depths of a perspective view are those of its formula", "[pipeline]") {
  const glm::mat4 m = *perspective(1.0471975511965976, 4.0 / 3.0, 1, 10, ClipVolume::minus_w_to_w);
  for_every_instruction_set([&](InstructionSet set) {
    const ScreenMap map = screen_map({0, 0, 64, 64}, {}, ClipVolume::minus_w_to_w);
    for (const auto& [distance, ndc] : {std::pair{1.0f, -1.0}, {2.0f, 1.0 / 9}, {5.0f, 7.0 / 9}, {10.0f, 1.0}}) {
      const float z = m[2][2] * -distance + m[3][2], w = m[2][3] * -distance;
      CHECK(static_cast<double>(divided({0, 0, z, w}, map, set).depth) == Approx((ndc + 1) / 2).margin(1e-6));
    }
  });
}

TEST_CASE("divide: every instruction set puts a vertex in the same place", "[pipeline][exact]") {
  test::Random random(64);
  std::vector<std::array<float, 4>> corners;
  for (int i = 0; i < 2000; ++i) {
    const float w = random.between(0.001f, 1000);
    corners.push_back({w * random.between(-3, 3), w * random.between(-3, 3), w * random.between(-1, 1), w});
  }
  const ScreenMap map = screen_map({3, 5, 1001, 701}, {0, 1}, ClipVolume::minus_w_to_w);
  for_every_instruction_set([&](InstructionSet set) {
    VertexBatch batch = test::clip_batch(corners);
    PerspectiveDivide(map, set)(batch);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const double inverse = 1.0 / static_cast<double>(corners[i][3]);
      const auto screen = [&](std::size_t k, double scale, double offset) { return static_cast<double>(corners[i][k]) * inverse * scale + offset; };
      const bool same = batch.screen[i].x == snap(screen(0, map.x_scale, map.x_offset)) &&
                        batch.screen[i].y == snap(screen(1, map.y_scale, map.y_offset)) &&
                        batch.screen[i].depth == static_cast<float>(screen(2, map.depth_scale, map.depth_offset));
      if (!same) FAIL("seed 64, vertex " << i);
    }
  });
}

TEST_CASE("divide: vertices without a place on the screen still get some numbers", "[pipeline]") {
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const ScreenMap map = screen_map({0, 0, 64, 64}, {}, ClipVolume::minus_w_to_w);
  for_every_instruction_set([&](InstructionSet set) {
    for (const float odd : {0.0f, -1.0f, inf, -inf, nan, 1e-45f, 3e38f})
      for (std::size_t k = 0; k < 4; ++k) {
        std::array<float, 4> clip{0.5f, 0.5f, 0.5f, 1};
        clip[k] = odd;
        const Placed placed = divided(clip, map, set);
        CHECK((std::abs(placed.x) <= kGuardBandUnits && std::abs(placed.y) <= kGuardBandUnits));
      }
  });
}

TEST_CASE("culling: what faces away goes, by either winding", "[pipeline][case-07]") {
  const std::vector<std::array<std::int32_t, 2>> points{{0, 0}, {10000, 0}, {0, 10000}};
  const std::vector<std::array<std::uint32_t, 3>> both{{0, 1, 2}, {0, 2, 1}};  // clockwise, counter-clockwise
  using Numbers = std::vector<std::uint32_t>;
  for_every_instruction_set([&](InstructionSet set) {
    VertexBatch vertices = test::screen_batch(points);
    const auto left = [&](Winding front, CullFace cull) { return survivors({front, cull}, {0, 0, 64, 64}, vertices, both, set); };
    for (const Winding front : {Winding::clockwise, Winding::counter_clockwise}) CHECK(left(front, CullFace::none) == Numbers{0, 1});
    CHECK(left(Winding::clockwise, CullFace::back) == Numbers{0});
    CHECK(left(Winding::clockwise, CullFace::front) == Numbers{1});
    CHECK(left(Winding::counter_clockwise, CullFace::back) == Numbers{1});
    CHECK(left(Winding::counter_clockwise, CullFace::front) == Numbers{0});
  });
}

TEST_CASE("culling: no area is no triangle, one unit is", "[pipeline][case-07]") {
  const std::vector<std::array<std::int32_t, 2>> points{{-8388608, -8388608}, {8388607, 8388606}, {-8388607, -8388607}, {8388606, 8388605}, {0, 0}};
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {0, 1, 3}, {0, 0, 1}, {0, 1, 0}, {4, 4, 4}};
  for_every_instruction_set([&](InstructionSet set) {
    VertexBatch vertices = test::screen_batch(points);
    CHECK(survivors({}, {0, 0, 64, 64}, vertices, triangles, set) == std::vector<std::uint32_t>{0, 1});
    CHECK(survivors({Winding::clockwise, CullFace::back}, {0, 0, 64, 64}, vertices, triangles, set) == std::vector<std::uint32_t>{0});
    CHECK(survivors({Winding::clockwise, CullFace::front}, {0, 0, 64, 64}, vertices, triangles, set) == std::vector<std::uint32_t>{1});
  });
}

TEST_CASE("culling: what holds no centre of a drawable pixel goes", "[pipeline]") {
  const std::vector<std::array<std::int32_t, 2>> points{{129, 129}, {383, 129}, {129, 383}, {385, 129}, {385, 385}, {20000, 0}, {20000, 20000}, {30000, 100}};
  // Between four centres; around that of pixel (1, 1), on its left edge; right of the scissor.
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {0, 3, 4}, {5, 6, 7}};
  for_every_instruction_set([&](InstructionSet set) {
    VertexBatch vertices = test::screen_batch(points);
    CHECK(survivors({}, {0, 0, 64, 64}, vertices, triangles, set) == std::vector<std::uint32_t>{1});
    CHECK(survivors({}, {0, 0, 200, 64}, vertices, triangles, set) == std::vector<std::uint32_t>{1, 2});
    CHECK(survivors({}, {10, 10, 10, 20}, vertices, triangles, set).empty());
  });
}

TEST_CASE("culling: survivors run clockwise, in order, with what belongs to them", "[pipeline]") {
  test::Random random(65);
  std::vector<std::array<std::int32_t, 2>> points;
  for (int i = 0; i < 300; ++i) points.push_back({static_cast<std::int32_t>(random.below(16384)), static_cast<std::int32_t>(random.below(16384))});
  for_every_instruction_set([&](InstructionSet set) {
    VertexBatch vertices = test::screen_batch(points);
    TriangleBatch triangles;
    for (std::uint32_t i = 0; i < 300; i += 3) triangles.add(i, i + 1, i + 2, i + 1, i / 3);
    Culling({}, {0, 0, 64, 64}, set)(vertices, triangles);
    CHECK(triangles.count > 90);
    for (std::size_t i = 0; i < static_cast<std::size_t>(triangles.count); ++i) {
      const auto at = [&](std::uint32_t slot) { return SnappedPoint{points[slot][0], points[slot][1]}; };
      CHECK(twice_area(at(triangles.v0[i]), at(triangles.v1[i]), at(triangles.v2[i])) > 0);
      CHECK(triangles.v0[i] == 3 * triangles.primitive[i]);
      CHECK(triangles.provoking[i] == triangles.v0[i] + 1);
      if (i > 0) CHECK(triangles.primitive[i] > triangles.primitive[i - 1]);
    }
  });
}

}  // namespace tuberia
