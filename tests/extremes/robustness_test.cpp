// Numbers that are none, targets and viewports of odd sizes, and drawing again: cases 15, 16 and 34.

#include <catch2/catch.hpp>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {

namespace {

constexpr float kInf = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kMost = std::numeric_limits<float>::max(), kLeast = std::numeric_limits<float>::denorm_min();

/// A triangle of clip positions, of which one coordinate shall be odd.
struct OddTriangle {
  std::array<glm::vec4, 3> positions{{{-0.75f, -0.5f, 0.5f, 1}, {0.5f, -0.75f, 0.5f, 1}, {0, 0.75f, 0.5f, 1}}};
  std::array<glm::vec4, 3> colours{{{1, 0.5f, 0.25f, 1}, {1, 0.5f, 0.25f, 1}, {1, 0.5f, 0.25f, 1}}};
  MeshView view() const { return {.clip_positions = positions, .colours = colours}; }
};

std::int64_t pixels_of(const PipelineState& state, int width, int height) {
  test::Mesh all;
  all.positions = {{-10, -10, 0}, {30, -10, 0}, {-10, 30, 0}};
  return test::pixels_drawn(test::render(all, gouraud(), state, {.width = width, .height = height}).colour);
}

}  // namespace

TEST_CASE("robustness: a vertex with an odd number spoils nothing but its triangle", "[extremes][C1][case-16]") {
  const test::Mesh good = test::rectangle({-1, -1, 0.25f}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  test::for_every_instruction_set([&](InstructionSet set) {
    test::Studio studio({.width = 33, .height = 31, .options = {.threads = 1, .instruction_set = set}});
    const auto frame = [&](const OddTriangle* odd) {
      studio.pipeline().clear(studio.target(), {0, 0, 0, 0});
      PipelineState state;
      if (odd != nullptr) studio.draw(odd->view(), gouraud(), state);
      state.depth = kDepthOff;
      studio.draw(good.view(), gouraud(), state);
      return studio.target().colour_image();
    };
    const Image<Rgba8> without = frame(nullptr);
    for (const float odd : {kNan, -kNan, kInf, -kInf, kMost, -kMost, 3e38f, -3e38f, kLeast, -kLeast, 0.0f, -0.0f})
      for (const int coordinate : {0, 1, 2, 3})
        for (std::size_t vertex = 0; vertex < 3; ++vertex) {
          INFO("vertex " << vertex << ", coordinate " << coordinate << ", value " << odd);
          OddTriangle triangle;
          triangle.positions[vertex][coordinate] = odd;
          const Image<Rgba8> with = frame(&triangle);
          // Drawn last, the square shows unchanged; with no number at all, the triangle is dropped.
          for (int y = 16; y < 31; ++y)
            for (int x = 0; x < 16; ++x)
              if (with.at(x, y) != without.at(x, y)) FAIL("pixel " << x << ", " << y);
          if (!std::isfinite(odd)) CHECK(with == without);
        }
  });
}

TEST_CASE("robustness: a dropped triangle leaves its neighbours in the mesh", "[extremes][C1][case-16]") {
  test::Mesh mesh = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});
  mesh.positions.push_back({kNan, 0, 0});
  mesh.normals.clear(), mesh.texcoords.clear(), mesh.colours.clear();
  mesh.indices = {0, 1, 4, 0, 1, 2, 4, 4, 4, 0, 2, 3, 2, 4, 3};
  test::Studio studio({});
  const DrawStatistics drawn = studio.draw(mesh.view(), gouraud());
  CHECK(drawn.triangles_in == 5);
  CHECK(drawn.triangles_drawn == 2);
  CHECK(test::pixels_drawn(studio.target().colour_image()) == 64 * 64);
}

TEST_CASE("robustness: odd targets are filled to their last pixel", "[extremes][R5][case-15]") {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 100}, {100, 1}, {16384, 1}, {1, 16384}, {65, 129}})
    CHECK(pixels_of({}, width, height) == std::int64_t{width} * height);
}

TEST_CASE("robustness: nothing is drawn outside the viewport and the scissor", "[extremes][R5][case-15]") {
  const auto pixels = [](std::optional<Viewport> viewport, std::optional<PixelRect> scissor) {
    PipelineState state;
    state.viewport.viewport = viewport;
    state.rasterization.scissor = scissor;
    return pixels_of(state, 64, 64);
  };
  CHECK(pixels(Viewport{-7, 5, 30, 20}, {}) == 23 * 20);
  CHECK(pixels(Viewport{50, 60, 30, 20}, {}) == 14 * 4);
  CHECK(pixels(Viewport{64, 0, 30, 20}, {}) == 0);
  CHECK(pixels(Viewport{-16384, -16384, 16384, 16384}, {}) == 0);
  CHECK(pixels(Viewport{10, 10, 0, 20}, {}) == 0);
  CHECK(pixels(Viewport{10, 10, 20, 0}, {}) == 0);
  CHECK(pixels({}, PixelRect{3, 5, 9, 10}) == 6 * 5);
  CHECK(pixels({}, PixelRect{3, 5, 3, 10}) == 0);
  CHECK(pixels({}, PixelRect{9, 10, 3, 5}) == 0);
  CHECK(pixels({}, PixelRect{-2147483647, -2147483647, 2147483647, 2147483647}) == 64 * 64);
  CHECK(pixels(Viewport{-7, 5, 30, 20}, PixelRect{20, 0, 40, 7}) == 3 * 2);
}

TEST_CASE("robustness: a viewport as large as can be shows the same as any", "[extremes][R5]") {
  // The part of a huge picture that the target sees is a corner of the square.
  PipelineState state;
  state.viewport.viewport = Viewport{-16384, -16384, 16384, 16384};
  CHECK(pixels_of(state, 5, 5) == 0);
  state.viewport.viewport = Viewport{-16380, -16379, 16384, 16384};
  CHECK(pixels_of(state, 64, 64) == 4 * 5);
}

TEST_CASE("robustness: drawing again with the same state meets the same depths", "[extremes][P5][case-34]") {
  const test::Mesh ball = test::sphere(20), floor = test::rectangle({-30, -1, -30}, {0, 0, 60}, {60, 0, 0}, {0, 1, 0}, 40);
  for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f})
    for (const Precision precision : {Precision::exact, Precision::fast}) {
      test::Studio studio({.width = 120, .height = 90, .depth = format, .options = {.threads = 2, .precision = precision}});
      PipelineState state;
      state.transform.clip_from_world = test::clip_from_world({1.5, 1.25, 2.5}, 4.0 / 3.0);
      for (const Compare test : {Compare::less_equal, Compare::equal}) {
        state.depth.test = test;
        // The second time by another program: the geometry decides, not what is done with it.
        const FragmentProgram program = test == Compare::equal ? flat() : phong({});
        for (const test::Mesh* mesh : {&ball, &floor}) {
          test::Mesh coloured = *mesh;
          coloured.colours.assign(coloured.positions.size(), glm::vec4(0, 1, 0, 1));
          studio.draw(coloured.view(), program, state);
        }
      }
      INFO("depth format " << static_cast<int>(format) << ", precision " << static_cast<int>(precision));
      const Image<Rgba8> image = studio.target().colour_image();
      const auto not_drawn_again = [](const Rgba8& p) { return p != Rgba8{0, 0, 0, 0} && p != Rgba8{0, 255, 0, 255}; };
      CHECK(std::count_if(image.pixels().begin(), image.pixels().end(), not_drawn_again) == 0);
    }
}

}  // namespace tuberia
