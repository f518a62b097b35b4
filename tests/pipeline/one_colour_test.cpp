// Triangles of one colour: the tile loops prepare what they store or lay over once a triangle.

#include <catch2/catch.hpp>

#include <limits>

#include "pipeline/programs/programs.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/random.hpp"
#include "tests/support/render.hpp"

namespace tuberia {
namespace {

/// A rectangle over a quarter of the target or more, cut by the pixels' groups and tiles at random.
test::Mesh random_rectangle(test::Random& random, const glm::vec4& colour) {
  const glm::vec3 corner(random.between(-1, 0), random.between(-1, 0), 0);
  test::Mesh mesh = test::rectangle(corner, {random.between(0.5f, 1), 0, 0}, {0, random.between(0.5f, 1), 0}, {0, 0, 1});
  mesh.colours.assign(mesh.positions.size(), colour);
  return mesh;
}

}  // namespace

TEST_CASE("one colour: laid beforehand or fragment by fragment, the pixels are the same", "[pipeline][exact]") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::srgb8, ColourFormat::rgba32f})
      for (const BlendMode mode : {BlendMode::replace, BlendMode::source_over, BlendMode::additive}) {
        test::Random random(1302);
        const test::Canvas canvas{.width = 101, .height = 77, .colour = format, .background = {0.2f, 0.3f, 0.1f, 0.6f},
                                  .options = {.instruction_set = set, .precision = precision}};
        test::Studio fused(canvas), staged(canvas);
        PipelineState state;
        state.depth = kDepthOff;
        state.blend.mode = mode;
        for (int layer = 0; layer < 40; ++layer) {
          const auto any = [&] { return layer == 20 && format != ColourFormat::rgba32f ? nan : random.between(-0.25f, 1.25f); };
          const test::Mesh mesh = random_rectangle(random, {any(), any(), any(), random.between(0, 1)});
          DrawCall call{.mesh = mesh.view(), .program = flat(), .state = state};
          REQUIRE(fused.pipeline().draw(fused.target(), call).ok());
          call.count_fragments = true;
          REQUIRE(staged.pipeline().draw(staged.target(), call).ok());
          INFO("format " << static_cast<int>(format) << ", mode " << static_cast<int>(mode) << ", layer " << layer);
          REQUIRE(staged.digest() == fused.digest());
        }
      }
  });
}

}  // namespace tuberia
