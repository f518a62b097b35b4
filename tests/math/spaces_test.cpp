#include "math/spaces.hpp"

#include <catch2/catch.hpp>

namespace tuberia {

TEST_CASE("spaces: the division by w keeps points on the w = 1 plane", "[math]") {
  CHECK(divide({.x = 0.25f, .y = -0.5f, .z = 0.75f, .w = 1.0f}) == NdcPosition{0.25f, -0.5f, 0.75f});
  CHECK(divide({.x = 3.0f, .y = -6.0f, .z = 1.5f, .w = 6.0f}) == NdcPosition{0.5f, -1.0f, 0.25f});
}

TEST_CASE("spaces: the corners of ndc are the corners of the viewport, y down", "[math]") {
  const Viewport viewport{.x = -7, .y = 5, .width_pixels = 641, .height_pixels = 480};
  const auto volume = GENERATE(ClipVolume::minus_w_to_w, ClipVolume::zero_to_w);
  const auto at = [&](float x, float y) { return screen_from_ndc({x, y, 0.5f}, viewport, {}, volume); };
  CHECK(at(-1, 1).x == -7.0f);
  CHECK(at(-1, 1).y == 5.0f);
  CHECK(at(1, -1).x == 634.0f);
  CHECK(at(1, -1).y == 485.0f);
  CHECK(at(0, 0).x == 313.5f);
  CHECK(at(0, 0).y == 245.0f);
}

TEST_CASE("spaces: depth runs from one end of the range to the other in both clip volumes", "[math]") {
  const Viewport viewport{.width_pixels = 4, .height_pixels = 4};
  const auto depth = [&](float z, DepthRange range, ClipVolume volume) {
    return screen_from_ndc({0, 0, z}, viewport, range, volume).depth;
  };
  CHECK(depth(-1.0f, {}, ClipVolume::minus_w_to_w) == 0.0f);
  CHECK(depth(0.0f, {}, ClipVolume::minus_w_to_w) == 0.5f);
  CHECK(depth(1.0f, {}, ClipVolume::minus_w_to_w) == 1.0f);
  CHECK(depth(0.0f, {}, ClipVolume::zero_to_w) == 0.0f);
  CHECK(depth(1.0f, {}, ClipVolume::zero_to_w) == 1.0f);
  const DepthRange swapped{.near_depth = 0.75f, .far_depth = 0.25f};
  CHECK(depth(0.0f, swapped, ClipVolume::zero_to_w) == 0.75f);
  CHECK(depth(1.0f, swapped, ClipVolume::zero_to_w) == 0.25f);
}

// notes 15.3
TEST_CASE("spaces: the notes' frame has integer pixel centres and y up", "[math]") {
  CHECK(notes_frame_from_ndc({-1, -1, 0}, 640, 480) == NotesFramePosition{-0.5f, -0.5f});
  CHECK(notes_frame_from_ndc({0, 0, 0}, 640, 480) == NotesFramePosition{319.5f, 239.5f});
  CHECK(notes_frame_from_ndc({1, 1, 0}, 640, 480) == NotesFramePosition{639.5f, 479.5f});
}

TEST_CASE("spaces: screen space is the notes' frame shifted by half a pixel and flipped", "[math]") {
  for (const float x : {-1.0f, -0.75f, 0.0f, 0.125f, 1.0f}) {
    const NdcPosition ndc{x, -0.5f * x, 0.0f};
    const auto screen = screen_from_ndc(ndc, {.width_pixels = 640, .height_pixels = 480}, {},
                                        ClipVolume::minus_w_to_w);
    const auto notes = notes_frame_from_ndc(ndc, 640, 480);
    CHECK(screen.x == notes.x + 0.5f);
    CHECK(screen.y == 480.0f - (notes.y + 0.5f));
  }
}

}  // namespace tuberia
