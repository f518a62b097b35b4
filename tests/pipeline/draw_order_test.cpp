// Hidden surfaces: meeting triangles last first, and leaving out what blocks hide, changes no bit. The
// stages one by one, which know neither, are the witness.

#include <catch2/catch.hpp>

#include <algorithm>

#include "pipeline/draw_order.hpp"
#include "pipeline/programs/programs.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"
#include "tests/support/render.hpp"

namespace tuberia {
namespace {

enum class Trend { none, nearer, farther };

/// Triangles of all sizes at few depths, so that many tie; some lean through the others.
test::Mesh heap_of_triangles(std::uint64_t seed, int count, Trend trend) {
  test::Random random(seed);
  std::vector<float> depths;
  for (int i = 0; i < count; ++i) depths.push_back(-0.75f + 0.25f * static_cast<float>(random.below(7)));
  if (trend == Trend::nearer) std::sort(depths.begin(), depths.end(), std::greater<>());
  if (trend == Trend::farther) std::sort(depths.begin(), depths.end());
  test::Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const float sizes[] = {0.02f, 0.1f, 0.4f, 3};
    const float size = sizes[i % 16 == 0 ? 3 : random.below(3)], lean = random.below(5) == 0 ? 0.3f : 0;
    const glm::vec3 centre(random.between(-1, 1), random.between(-1, 1), depths[static_cast<std::size_t>(i)]);
    const glm::vec4 colour(random.between(0, 1), random.between(0, 1), random.between(0, 1), random.between(0, 1));
    for (int corner = 0; corner < 3; ++corner) {
      mesh.positions.push_back(centre + glm::vec3(random.between(-size, size), random.between(-size, size), random.between(-lean, lean)));
      mesh.colours.push_back(colour);
    }
  }
  return mesh;
}

/// Whether the tile loops and the single stages leave the same, over what an earlier draw left.
bool leave_the_same(const test::Canvas& canvas, const test::Mesh& mesh, const PipelineState& state) {
  test::Studio fused(canvas), staged(canvas);
  PipelineState first;
  first.depth.write = true;
  const test::Mesh background = heap_of_triangles(9, 40, Trend::none);
  for (test::Studio* studio : {&fused, &staged})
    REQUIRE(studio->pipeline().draw(studio->target(), {.mesh = background.view(), .program = gouraud(), .state = first}).ok());
  DrawCall call{.mesh = mesh.view(), .program = gouraud(), .state = state};
  REQUIRE(fused.pipeline().draw(fused.target(), call).ok());
  call.count_fragments = true;
  REQUIRE(staged.pipeline().draw(staged.target(), call).ok());
  return fused.digest() == staged.digest();
}

constexpr Compare kAllComparisons[] = {Compare::never, Compare::less, Compare::equal, Compare::less_equal,
                                       Compare::greater, Compare::not_equal, Compare::greater_equal, Compare::always};

}  // namespace

TEST_CASE("hidden surfaces: leaving them out changes no pixel and no depth", "[pipeline][exact]") {
  const DepthFormat format = GENERATE(DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f);
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const test::Canvas canvas{.width = 150, .height = 100, .depth = format, .far_depth = 0.6f, .options = {.instruction_set = set, .precision = precision}};
    for (const Trend trend : {Trend::none, Trend::nearer, Trend::farther}) {
      const test::Mesh mesh = heap_of_triangles(1401, 300, trend);
      for (const Compare compare : kAllComparisons)
        for (const bool write : {true, false})
          for (const BlendMode mode : {BlendMode::replace, BlendMode::source_over}) {
            PipelineState state;
            state.depth = {.test = compare, .write = write};
            state.blend.mode = mode;
            INFO("trend " << static_cast<int>(trend) << ", compare " << static_cast<int>(compare) << ", write " << write << ", mode "
                          << static_cast<int>(mode));
            CHECK(leave_the_same(canvas, mesh, state));
          }
    }
  });
}

TEST_CASE("hidden surfaces: no bit changes over many batches of chunks either", "[pipeline][exact]") {
  const test::Canvas canvas{.width = 300, .height = 200, .far_depth = 0.6f};
  for (const Trend trend : {Trend::nearer, Trend::farther}) {
    const test::Mesh mesh = heap_of_triangles(1402, 80'000, trend);
    for (const Compare compare : {Compare::less, Compare::less_equal, Compare::greater, Compare::always}) {
      PipelineState state;
      state.depth.test = compare;
      INFO("trend " << static_cast<int>(trend) << ", compare " << static_cast<int>(compare));
      CHECK(leave_the_same(canvas, mesh, state));
    }
  }
}

TEST_CASE("draw order: last first where later triangles are nearer, or the last one wins", "[pipeline]") {
  const auto order = [](Trend trend, Compare compare, DepthRange range = {}, BlendMode mode = BlendMode::replace) {
    const test::Mesh mesh = heap_of_triangles(1403, 500, trend);
    PipelineState state;
    state.depth.test = compare;
    state.blend.mode = mode;
    state.viewport.depth_range = range;
    AcceptedDraw accepted;
    accepted.output.depth = state.depth;
    accepted.output.blend = state.blend;
    return choose_draw_order({.mesh = mesh.view(), .program = gouraud(), .state = state}, accepted);
  };
  CHECK(order(Trend::nearer, Compare::less) == DrawOrder::last_first);
  CHECK(order(Trend::farther, Compare::less) == DrawOrder::as_submitted);
  CHECK(order(Trend::nearer, Compare::greater) == DrawOrder::as_submitted);
  CHECK(order(Trend::farther, Compare::greater_equal) == DrawOrder::last_first);
  CHECK(order(Trend::nearer, Compare::less, {.near_depth = 1, .far_depth = 0}) == DrawOrder::as_submitted);
  CHECK(order(Trend::farther, Compare::always) == DrawOrder::last_first);
  CHECK(order(Trend::nearer, Compare::not_equal) == DrawOrder::as_submitted);
  CHECK(order(Trend::nearer, Compare::less, {}, BlendMode::source_over) == DrawOrder::as_submitted);
}

}  // namespace tuberia
