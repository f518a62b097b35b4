// Rules R1, R4 and R5: the snap, triangles without an area, and what is never written.

#include <catch2/catch.hpp>

#include "tests/support/drawn_coverage.hpp"
#include "tests/support/every_instruction_set.hpp"

namespace tuberia {

using test::for_every_instruction_set;
using test::Triangle;

namespace {

/// The middle pixel of an 8x8 target, if a small right triangle at (x, y) pixels covers it.
bool covers_pixel_4(double x_pixels, double y_pixels, float w, InstructionSet set) {
  const auto corner = [&](double x, double y) {
    return glm::vec4(static_cast<float>((x / 4 - 1)) * w, static_cast<float>(1 - y / 4) * w, 0, w);
  };
  const std::vector<glm::vec4> positions{corner(x_pixels, y_pixels), corner(x_pixels + 0.75, y_pixels), corner(x_pixels, y_pixels + 0.75)};
  test::Studio studio({.width = 8, .height = 8, .options = {.threads = 1, .instruction_set = set}});
  studio.draw({.clip_positions = positions}, gouraud());
  const Image<Rgba8> image = studio.target().colour_image();
  CHECK(test::pixels_drawn(image) <= 1);
  return image.at(4, 4).a != 0;
}

std::int64_t triangles_drawn(const Triangle& triangle, CullFace cull, InstructionSet set) {
  test::Studio studio({.width = 8, .height = 8, .options = {.threads = 1, .instruction_set = set}});
  const auto vertices = test::screen_vertices({&triangle, 1});
  PipelineState state;
  state.culling.cull = cull;
  const std::int64_t drawn = studio.draw({.screen_positions = vertices}, flat(), state).triangles_drawn;
  CHECK((drawn > 0) == (test::pixels_drawn(studio.target().colour_image()) > 0));
  return drawn;
}

}  // namespace

TEST_CASE("snap: it comes after the division and the viewport, to the nearest 256th", "[extremes][R1][case-06]") {
  // The corner with the right angle owns its pixel only if it is snapped to the centre or before it:
  // half a unit beyond it is a tie, which goes back to the even number.
  for_every_instruction_set([](InstructionSet set) {
    for (const float w : {1.0f, 3.0f, 1e-6f, 1e6f, 0x1p-60f}) {
      INFO("w " << w);
      CHECK(covers_pixel_4(4.5, 4.5, w, set));
      CHECK(covers_pixel_4(4.5 - 0.25, 4.5, w, set));
      CHECK_FALSE(covers_pixel_4(4.5 + 0.75 / 256, 4.5, w, set));
      CHECK_FALSE(covers_pixel_4(4.5, 4.5 + 0.75 / 256, w, set));
      CHECK(covers_pixel_4(4.5 + 0.25 / 256, 4.5 + 0.25 / 256, w, set));
    }
    CHECK(covers_pixel_4(4.5 + 0.5 / 256, 4.5 + 0.5 / 256, 1, set));
    CHECK_FALSE(covers_pixel_4(4.5 + 1.5 / 256, 4.5, 1, set));
  });
}

TEST_CASE("snap: what is culled and interpolated is the snapped triangle", "[extremes][R1][R4]") {
  for_every_instruction_set([](InstructionSet set) {
    // 0.3 units wide before the snap, nothing after it.
    const float x = 0.5f / 4 - 1, thin = 0.3f / 256 / 4;
    const std::vector<glm::vec4> vanishing{{x, 1, 0, 1}, {x + thin, 1, 0, 1}, {x, -1, 0, 1}};
    test::Studio studio({.width = 8, .height = 8, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set}});
    CHECK(studio.draw({.clip_positions = vanishing}, gouraud()).triangles_drawn == 0);
    // A ramp whose ends are snapped outwards by 0.4 of a unit each has the slope of the snapped one.
    const auto at = [](double pixels) { return static_cast<float>(pixels / 4 - 1); };
    const float left = at(-1.0 - 0.6 / 256), right = at(9.0 + 0.6 / 256);
    const std::vector<glm::vec4> ramp{{left, 1, 0, 1}, {right, 1, 0, 1}, {right, -1, 0, 1}, {left, -1, 0, 1}};
    const std::vector<glm::vec4> colours{{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 1}, {0, 0, 0, 1}};
    const std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3};
    studio.draw({.clip_positions = ramp, .colours = colours, .indices = indices}, gouraud());
    const double snapped_left = -1 - 1.0 / 256, snapped_width = 10 + 2.0 / 256;
    for (int i = 0; i < 8; ++i)
      CHECK(static_cast<double>(studio.target().linear_image().at(i, 3).r) == Approx((i + 0.5 - snapped_left) / snapped_width).margin(2e-7));
  });
}

TEST_CASE("areas: of zero nothing is drawn, of one unit everything that it owns", "[extremes][R4][case-07]") {
  const Triangle plus{SnappedPoint{128, 128}, {129, 128}, {128, 129}}, minus{plus[0], plus[2], plus[1]};
  const std::vector<Triangle> zero{{SnappedPoint{128, 128}, {128, 128}, {128, 128}},
                                   {SnappedPoint{0, 0}, {1024, 1024}, {512, 512}},
                                   {SnappedPoint{128, 0}, {128, 2048}, {128, 1024}},
                                   {SnappedPoint{-8388608, -8388608}, {8388607, 8388607}, {128, 128}}};
  CHECK(twice_area(plus[0], plus[1], plus[2]) == 1);
  CHECK(twice_area(minus[0], minus[1], minus[2]) == -1);
  for_every_instruction_set([&](InstructionSet set) {
    for (const CullFace cull : {CullFace::none, CullFace::back, CullFace::front}) {
      INFO("culling " << static_cast<int>(cull));
      for (const Triangle& triangle : zero) CHECK(triangles_drawn(triangle, cull, set) == 0);
      // Clockwise on the screen is the back unless the state says otherwise.
      CHECK(triangles_drawn(plus, cull, set) == (cull == CullFace::back ? 0 : 1));
      CHECK(triangles_drawn(minus, cull, set) == (cull == CullFace::front ? 0 : 1));
    }
  });
}

TEST_CASE("borders: no triangle writes outside the viewport or the scissor", "[extremes][R5][case-15]") {
  test::Random random(0x5e);
  for (int i = 0; i < 60; ++i) {
    const Viewport viewport{static_cast<int>(random.below(80)) - 20, static_cast<int>(random.below(60)) - 20, static_cast<int>(random.below(90)), static_cast<int>(random.below(70))};
    PixelRect scissor{static_cast<int>(random.below(70)), static_cast<int>(random.below(50)), 0, 0};
    scissor.right = scissor.left + static_cast<int>(random.below(60)), scissor.bottom = scissor.top + static_cast<int>(random.below(60));
    const PixelRect allowed = intersection(scissor, {viewport.x, viewport.y, viewport.x + viewport.width_pixels, viewport.y + viewport.height_pixels});
    std::vector<glm::vec4> positions;
    for (int k = 0; k < 90; ++k) {
      const float reach = k % 9 < 3 ? 1e30f : k % 9 < 6 ? 300.0f : 3.0f;
      positions.push_back({random.between(-reach, reach), random.between(-reach, reach), random.between(-1, 1), random.between(-0.5f, 1)});
    }
    PipelineState state;
    state.viewport.viewport = viewport;
    state.rasterization.scissor = scissor;
    for (const int samples : {1, 4}) {
      test::Studio studio({.width = 71, .height = 53, .samples = samples});
      studio.draw({.clip_positions = positions}, flat(), state);
      const Image<Rgba8> image = studio.target().colour_image();
      INFO("seed 0x5e, scene " << i << ", " << samples << " samples");
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
          const bool inside = x >= allowed.left && x < allowed.right && y >= allowed.top && y < allowed.bottom;
          if (!inside && image.at(x, y) != Rgba8{0, 0, 0, 0}) FAIL("pixel " << x << ", " << y);
        }
    }
  }
}

}  // namespace tuberia
