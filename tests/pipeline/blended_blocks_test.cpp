// Triangles whose fragments the tile loops need not treat one group at a time: what is known of all of
// them is prepared once a triangle, and whole blocks that are seen take a shorter way.

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

/// Draws the same in the tile loops and, counting fragments, stage by stage.
void draw_both(test::Studio& fused, test::Studio& staged, DrawCall call) {
  REQUIRE(fused.pipeline().draw(fused.target(), call).ok());
  call.count_fragments = true;
  REQUIRE(staged.pipeline().draw(staged.target(), call).ok());
  REQUIRE(staged.digest() == fused.digest());
}

/// A transformation of which the plane z = 0 leans into the screen, and its opposite.
glm::mat4 leaning(float lean) {
  glm::mat4 clip_from_world(1);
  clip_from_world[0][3] = lean;
  clip_from_world[1][3] = lean / 2;
  clip_from_world[2][2] = -1;
  return clip_from_world;
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
          INFO("format " << static_cast<int>(format) << ", mode " << static_cast<int>(mode) << ", layer " << layer);
          draw_both(fused, staged, {.mesh = mesh.view(), .program = flat(), .state = state});
        }
      }
  });
}

TEST_CASE("blended blocks: interpolated colours laid over whole blocks are those of single groups", "[pipeline][exact]") {
  test::for_every_machine([](InstructionSet set, Precision precision) {
    for (const float lean : {0.0f, 0.3f, 0.95f}) {
      test::Random random(1303);
      const test::Canvas canvas{.width = 200, .height = 150, .background = {0.2f, 0.3f, 0.1f, 0.6f},
                                .options = {.instruction_set = set, .precision = precision}};
      test::Studio fused(canvas), staged(canvas);
      PipelineState state;
      state.depth = kDepthOff;
      state.transform.clip_from_world = leaning(lean);
      state.blend.mode = BlendMode::source_over;
      for (int layer = 0; layer < 48; ++layer) {
        test::Mesh mesh = random_rectangle(random, {0, 0, 0, 0});
        // By turns: inside [0, 1], up to its ends, beyond them, the same at all vertices; alpha alike or not.
        const float beyond = layer % 4 == 0 ? -0.1f : layer % 4 == 2 ? 0.25f : 0.0f;
        const auto channel = [&] { return layer % 4 == 1 ? static_cast<float>(random.below(2)) : random.between(-beyond, 1 + beyond); };
        const float alpha = random.between(0, 1);
        for (glm::vec4& c : mesh.colours) {
          c = {channel(), channel(), channel(), layer % 3 == 0 ? random.between(0, 1) : alpha};
          if (layer % 4 == 3) c = {alpha, 1, 0, c.a};
        }
        if (layer % 5 == 4) mesh.colours[static_cast<std::size_t>(random.below(4))].g = std::numeric_limits<float>::quiet_NaN();
        INFO("lean " << lean << ", layer " << layer);
        draw_both(fused, staged, {.mesh = mesh.view(), .program = gouraud(), .state = state});
      }
    }
  });
}

TEST_CASE("blended blocks: what is nearer still hides them", "[pipeline][exact]") {
  test::for_every_instruction_set([](InstructionSet set) {
    for (const DepthFormat depth : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f})
      for (const Compare compare : {Compare::less, Compare::less_equal, Compare::greater, Compare::greater_equal, Compare::always}) {
        test::Random random(1304);
        const test::Canvas canvas{.width = 200, .height = 150, .depth = depth, .background = {0.2f, 0.3f, 0.1f, 0.6f},
                                  .options = {.instruction_set = set}};
        test::Studio fused(canvas), staged(canvas);
        PipelineState behind, blended;
        behind.depth = {.test = Compare::always, .write = true};
        blended.depth = {.test = compare, .write = false};
        blended.blend.mode = BlendMode::source_over;
        for (int layer = 0; layer < 30; ++layer) {
          // Depths that meet often: the test's ties are part of it.
          const float z = static_cast<float>(random.below(5) - 2) / 4;
          test::Mesh mesh = random_rectangle(random, {random.between(0, 1), random.between(0, 1), random.between(0, 1), 0.5f});
          for (glm::vec3& position : mesh.positions) position.z = z;
          const bool is_solid = layer % 5 == 0;
          INFO("depth format " << static_cast<int>(depth) << ", test " << static_cast<int>(compare) << ", layer " << layer);
          draw_both(fused, staged, {.mesh = mesh.view(), .program = layer % 2 == 0 ? flat() : gouraud(), .state = is_solid ? behind : blended});
        }
      }
  });
}

}  // namespace tuberia
