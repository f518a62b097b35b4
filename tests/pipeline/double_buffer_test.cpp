// What is shown is always a whole frame.

#include "raster/double_buffer.hpp"

#include <catch2/catch.hpp>

#include "pipeline/pipeline.hpp"
#include "pipeline/programs/programs.hpp"

using namespace tuberia;

namespace {

/// Covers the left or the right half of the target with one colour.
DrawCall half_covered(const std::array<glm::vec4, 6>& corners, const std::vector<glm::vec4>& colours) {
  DrawCall call;
  call.mesh.clip_positions = corners;
  call.mesh.colours = colours;
  call.program = flat();
  return call;
}

constexpr std::array<glm::vec4, 6> half_of(float left, float right) {
  return {glm::vec4{left, -1, 0, 1}, {right, -1, 0, 1}, {right, 1, 0, 1}, {left, -1, 0, 1}, {right, 1, 0, 1}, {left, 1, 0, 1}};
}

/// Whether an image is of one colour: no frame of which half is missing.
bool is_whole(const Image<Rgba8>& image) {
  for (const Rgba8& pixel : image.pixels())
    if (!(pixel == image.pixels()[0])) return false;
  return true;
}

}  // namespace

TEST_CASE("pipeline: dumps of the front buffer never show half a frame", "[pipeline][C37]") {
  Pipeline pipeline({.threads = 2});
  DoubleBuffer buffers = *DoubleBuffer::create({.width = 100, .height = 70});
  const auto left = half_of(-1, 0), right = half_of(0, 1);

  for (int frame = 1; frame <= 6; ++frame) {
    const Image<Rgba8> shown = buffers.front().colour_image();
    const std::vector<glm::vec4> colours(6, glm::vec4(static_cast<float>(frame) / 8, 0.5f, 0.25f, 1));
    pipeline.clear(buffers.back(), {0, 0, 0, 1});
    for (const auto& half : {left, right}) {
      REQUIRE(pipeline.draw(buffers.back(), half_covered(half, colours)));
      // The dump in the middle of a frame is the frame before, whole.
      CHECK(buffers.front().colour_image() == shown);
    }
    const Image<Rgba8> drawn = buffers.back().colour_image();
    buffers.swap();
    CHECK(buffers.front().colour_image() == drawn);
    CHECK(buffers.back().colour_image() == shown);
    CHECK(is_whole(buffers.front().colour_image()));
    CHECK(buffers.front().colour_image().at(99, 69).r == frame * 255 / 8 + (frame * 255 % 8 >= 4 ? 1 : 0));
  }
}

TEST_CASE("pipeline: half a frame is seen where it is not hidden by a back buffer", "[pipeline][C37]") {
  Pipeline pipeline({.threads = 1});
  DoubleBuffer buffers = *DoubleBuffer::create({.width = 100, .height = 70});
  const std::vector<glm::vec4> colours(6, glm::vec4(1));
  REQUIRE(pipeline.draw(buffers.back(), half_covered(half_of(-1, 0), colours)));
  CHECK_FALSE(is_whole(buffers.back().colour_image()));
  CHECK(is_whole(buffers.front().colour_image()));
}

TEST_CASE("pipeline: a double buffer of no size is refused as one target is", "[pipeline][C37]") {
  const auto refused = DoubleBuffer::create({.width = 0, .height = 70});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message == RenderTarget::create({.width = 0, .height = 70}).error().message);
}
