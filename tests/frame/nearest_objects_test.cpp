// Which object each pixel shows.

#include <catch2/catch.hpp>

#include "tests/frame/drawn_scene.hpp"
#include "tests/support/every_instruction_set.hpp"

namespace tuberia {
namespace {

/// A near square that lets light through, a far one behind it, and a third beside them, seen straight on.
constexpr const char* kThreeSquares = R"({
  "image": {"width": 30, "height": 20}, "camera": {"type": "orthographic", "eye": [0, 0, 10], "look_at": [0, 0, 0], "height": 4, "near": 1, "far": 21},
  "ambient": 1, "materials": {"plain": {"diffuse": 0.5}, "glass": {"diffuse": 0.5, "alpha": 0.25}},
  "objects": [
    {"shape": {"type": "plane"}, "material": "plain", "transforms": [{"rotate": 90, "about": [1, 0, 0]}, {"translate": [-2, 0, 0]}]},
    {"shape": {"type": "plane", "width": 1, "depth": 1}, "material": "glass", "transforms": [{"rotate": 90, "about": [1, 0, 0]}, {"translate": [-2, 0, 5]}]},
    {"shape": {"type": "plane"}, "material": "plain", "transforms": [{"rotate": 90, "about": [1, 0, 0]}, {"translate": [2, 0, -4]}]}]
})";

}  // namespace

TEST_CASE("frame: the nearest object of each pixel, and how far it is", "[A41][C06][frame]") {
  auto frame = SceneFrame::create(test::scene_from(kThreeSquares));
  REQUIRE(frame);
  for (const InstructionSet set : supported_instruction_sets()) {
    Pipeline pipeline({.threads = 2, .instruction_set = set});
    const auto seen = frame->nearest_objects(pipeline);
    REQUIRE(seen);
    // Five pixels are one unit. Depth of a parallel view: (10 - z - near) / (far - near).
    std::array<int, 4> pixels{};
    for (const int object : seen->objects.pixels()) ++pixels[static_cast<std::size_t>(object + 1)];
    CHECK(pixels == std::array<int, 4>{30 * 20 - 200, 100 - 25, 25, 100});
    CHECK(seen->objects.at(5, 10) == 1);
    CHECK(seen->objects.at(1, 6) == 0);
    CHECK(seen->objects.at(25, 10) == 2);
    CHECK(seen->objects.at(15, 10) == -1);
    CHECK(seen->depths.at(5, 10) == Approx(4 / 20.0));
    CHECK(seen->depths.at(1, 6) == Approx(9 / 20.0));
    CHECK(seen->depths.at(25, 10) == Approx(13 / 20.0));
    CHECK(seen->depths.at(15, 10) == 1);
  }
}

TEST_CASE("frame: the nearest objects do not change what the picture is", "[A41][frame]") {
  auto frame = SceneFrame::create(test::scene_from(kThreeSquares));
  REQUIRE(frame);
  Pipeline pipeline({.threads = 1});
  const auto before = frame->draw(pipeline);
  REQUIRE(frame->nearest_objects(pipeline));
  CHECK(*before == *frame->draw(pipeline));
}

}  // namespace tuberia
