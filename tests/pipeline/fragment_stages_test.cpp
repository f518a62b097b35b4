#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

#include "pipeline/alpha_test.hpp"
#include "pipeline/blending.hpp"
#include "pipeline/depth_test.hpp"
#include "pipeline/fog.hpp"
#include "pipeline/fragment_shading.hpp"
#include "pipeline/rasterization.hpp"
#include "tests/support/draws.hpp"
#include "tests/support/every_instruction_set.hpp"

namespace tuberia {

namespace {

/// Counts the calls of each stage.
struct CountingObserver : Observer {
  std::map<Stage, int> calls;
  int open = 0;
  void after(Stage stage, const Chunk&) override { ++calls[stage]; }
  void before(Stage, const Chunk&, const FragmentBlock& block, const Tile&) override {
    CHECK(block.live != 0);
    ++open;
  }
  void after(Stage stage, const Chunk&, const FragmentBlock&, const Tile&) override {
    ++calls[stage];
    if (stage != Stage::rasterization) --open;
  }
};

}  // namespace

TEST_CASE("fragment stages: watched and counted draws leave the bits of fused ones", "[pipeline][exact]") {
  for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::srgb8, ColourFormat::rgba32f})
    for (const DepthFormat depth : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f})
      test::for_every_machine([&](InstructionSet set, Precision precision) {
        const test::Canvas canvas{.width = 101, .height = 77, .colour = format, .depth = depth, .background = {0.2f, 0.3f, 0.1f, 1},
                                  .options = {.threads = 2, .instruction_set = set, .precision = precision}};
        test::Studio fused(canvas), counted(canvas), watched(canvas);
        for (const test::NamedDraw& one : test::everyday_draws()) {
          INFO(one.name << ", formats " << static_cast<int>(format) << " and " << static_cast<int>(depth));
          const std::string before = fused.digest();
          DrawCall call{.mesh = one.mesh.view(), .program = one.program, .state = one.state};
          fused.draw(call.mesh, call.program, call.state);
          CountingObserver observer;
          REQUIRE(watched.pipeline().draw(watched.target(), call, observer).ok());
          call.count_fragments = true;
          REQUIRE(counted.pipeline().draw(counted.target(), call).ok());
          CHECK(fused.digest() != before);
          CHECK(counted.digest() == fused.digest());
          CHECK(watched.digest() == fused.digest());
          CHECK(observer.calls[Stage::rasterization] > 0);
          CHECK(observer.open == 0);
        }
      });
}

TEST_CASE("fragment stages: what is counted is what is there", "[pipeline][exact]") {
  // A rectangle over the whole target, and one behind its left half.
  const test::Mesh near = test::rectangle({-1, -1, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 1}), far = test::rectangle({-2, -2, 0.5f}, {4, 0, 0}, {0, 4, 0}, {0, 0, 1});
  for (const int samples : {1, 2, 4, 8, 16})
    test::for_every_instruction_set([&](InstructionSet set) {
      INFO(samples << " samples");
      Pipeline pipeline({.threads = 3, .instruction_set = set});
      RenderTarget target = *RenderTarget::create({.width = 96, .height = 80, .samples = samples});
      const auto draw = [&](const test::Mesh& mesh, const PipelineState& state) {
        return *pipeline.draw(target, {.mesh = mesh.view(), .program = flat(), .state = state, .count_fragments = true});
      };
      const std::int64_t pixels = 96 * 80;
      const DrawStatistics first = draw(near, {});
      CHECK(first.samples_passed == pixels / 2 * samples);
      const DrawStatistics second = draw(far, {});
      // The diagonal's pixels are of both triangles where they have several samples.
      if (samples == 1) CHECK(second.fragments == pixels);
      CHECK(second.fragments >= pixels);
      CHECK(second.samples_passed == pixels / 2 * samples);
      CHECK(second.fragments_shaded < second.fragments);
      const DrawStatistics again = draw(far, {});
      CHECK(again.samples_passed == 0);
      CHECK(again.fragments_shaded == 0);
      PipelineState cut;
      cut.depth = kDepthOff;
      cut.rasterization.scissor = PixelRect{3, 5, 14, 9};
      CHECK(draw(far, cut).samples_passed == 11 * 4 * samples);
      PipelineState dropped = cut;
      dropped.alpha_test = {Compare::less, 0.5f};
      CHECK(draw(far, dropped).samples_passed == 0);
      CHECK(draw(far, dropped).fragments_shaded >= 44);
    });
}

TEST_CASE("fragment stages: counts of any scene are the same on every machine, and those of its pixels", "[pipeline][exact]") {
  const test::NamedDraw ball = test::everyday_draws()[2];
  std::int64_t passed = -1;
  test::for_every_instruction_set([&](InstructionSet set) {
    for (const int threads : {1, 3}) {
      test::Studio studio({.width = 101, .height = 77, .options = {.threads = threads, .instruction_set = set}});
      PipelineState state = ball.state;
      state.culling.cull = CullFace::back;
      const DrawCall call{.mesh = ball.mesh.view(), .program = ball.program, .state = state, .count_fragments = true};
      const DrawStatistics counted = *studio.pipeline().draw(studio.target(), call);
      CHECK(counted.samples_passed == test::pixels_drawn(studio.picture().colour));
      CHECK(counted.fragments_shaded == counted.samples_passed);
      if (passed < 0) passed = counted.samples_passed;
      CHECK(counted.samples_passed == passed);
    }
  });
}

TEST_CASE("fragment stages: where samples are all covered, the resolved picture is the plain one", "[pipeline][exact]") {
  const test::Mesh triangle{.positions = {{-1, -1, 0.1f}, {9, -1, 0.5f}, {-1, 9, 0.9f}}, .normals = {}, .texcoords = {},
                            .colours = {{1, 0, 0, 1}, {0, 1, 0, 0.5f}, {0, 0, 1, 0.25f}}, .custom = {}, .indices = {}};
  const auto drawn = [&](ColourFormat format, int samples) {
    Pipeline pipeline({.threads = 1});
    RenderTarget target = *RenderTarget::create({.width = 70, .height = 66, .colour = format, .samples = samples});
    REQUIRE(pipeline.draw(target, {.mesh = triangle.view(), .program = gouraud(), .state = {}}).ok());
    return target;
  };
  for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::srgb8, ColourFormat::rgba16f, ColourFormat::rgba32f})
    for (const int samples : {2, 4, 8, 16}) {
      INFO("format " << static_cast<int>(format) << ", samples " << samples);
      const RenderTarget sampled = drawn(format, samples), plain = drawn(format, 1);
      for (int s = 0; s < samples; ++s) CHECK(sampled.sample_linear_image(s) == plain.linear_image());
      // The sum of many equal floats may be rounded, that of codes and of halves is not.
      if (format != ColourFormat::rgba32f) CHECK(sampled.linear_image() == plain.linear_image());
    }
}

namespace {

std::string digest_of_staged(ColourFormat format, int samples, int threads, InstructionSet set) {
  Pipeline pipeline({.threads = threads, .instruction_set = set});
  RenderTarget target = *RenderTarget::create({.width = 133, .height = 90, .colour = format, .stencil = true, .samples = samples});
  pipeline.clear(target, {0.2f, 0.3f, 0.4f, 1});
  for (const test::NamedDraw& one : test::staged_draws(format == ColourFormat::rgba8)) {
    const auto drawn = pipeline.draw(target, {.mesh = one.mesh.view(), .program = one.program, .state = one.state});
    if (!drawn) FAIL(one.name << " was refused: " << drawn.error().message);
  }
  return test::digest_of_samples(target);
}

}  // namespace

TEST_CASE("fragment stages: threads and instruction sets agree on every state", "[pipeline][exact]") {
  for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::srgb8, ColourFormat::rgba16f, ColourFormat::rgba32f})
    for (const int samples : {1, 4, 16}) {
      INFO("format " << static_cast<int>(format) << ", samples " << samples);
      const std::string expected = digest_of_staged(format, samples, 1, supported_instruction_sets().front());
      for (const InstructionSet set : supported_instruction_sets())
        for (const int threads : {1, 2, 5}) {
          INFO(name_of(set) << ", " << threads << " threads");
          CHECK(digest_of_staged(format, samples, threads, set) == expected);
        }
    }
}

namespace {

/// Draws what comes out of set-up once more, into a target of its own, with the stages' own objects.
class LecturingObserver : public Observer {
 public:
  LecturingObserver(RenderTarget& target, const PipelineOptions& options) : target_(target), options_(options) {}
  void begin(const DrawCall& draw, const AcceptedDraw& accepted) override { draw_ = &draw, output_ = accepted.output; }
  void after(Stage stage, const Chunk& chunk) override {
    if (stage != Stage::set_up) return;
    const auto [set, precision] = std::pair{options_.instruction_set, options_.precision};
    const Rasterization rasterization(output_.clip, set, precision);
    const FragmentShading shading(draw_->program, draw_->state.rasterization.flat_shading, set, precision);
    const Fog fog(output_, set, precision);
    const AlphaTesting alpha_test(output_, set, precision);
    const DepthTest depth_test(output_, set, precision);
    const Blending blending(output_, set, precision);
    for (const ScreenTriangle& triangle : chunk.screen_triangles)
      for (FragmentBlock& block : rasterization.blocks(triangle, target_)) {
        shading(chunk.view(), block);
        fog(chunk.view(), block);
        alpha_test(block);
        depth_test(block, target_);
        blending(block, target_);
      }
  }

 private:
  RenderTarget& target_;
  PipelineOptions options_;
  const DrawCall* draw_ = nullptr;
  OutputState output_;
};

}  // namespace

TEST_CASE("fragment stages: each object alone, one after the other, leaves the bits of a draw", "[pipeline][exact]") {
  for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::rgba16f})
    for (const int samples : {1, 8})
      test::for_every_machine([&](InstructionSet set, Precision precision) {
        INFO("format " << static_cast<int>(format) << ", samples " << samples);
        Pipeline pipeline({.threads = 1, .instruction_set = set, .precision = precision});
        const RenderTargetDescription description{.width = 101, .height = 77, .colour = format, .stencil = true, .samples = samples};
        RenderTarget drawn = *RenderTarget::create(description), lectured = *RenderTarget::create(description);
        LecturingObserver observer(lectured, pipeline.options());
        for (const test::NamedDraw& one : test::staged_draws(format == ColourFormat::rgba8))
          REQUIRE(pipeline.draw(drawn, {.mesh = one.mesh.view(), .program = one.program, .state = one.state}, observer).ok());
        CHECK(test::digest_of_samples(lectured) == test::digest_of_samples(drawn));
        CHECK(test::digest_of_samples(drawn) != test::digest_of_samples(*RenderTarget::create(description)));
      });
}

TEST_CASE("fragment stages: alpha decides about the only sample, too", "[pipeline][exact]") {
  for (const float alpha : {0.25f, 0.75f}) {
    const test::Mesh mesh = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, 1, {1, 1, 1, alpha});
    PipelineState state;
    state.multisampling.alpha_to_coverage = true;
    const test::Picture picture = test::render(mesh, gouraud(), state, {.width = 20, .height = 10});
    CHECK(test::pixels_drawn(picture.colour) == (alpha < 0.5f ? 0 : 200));
  }
}

TEST_CASE("fragment stages: a stencil mask keeps what is drawn later inside", "[pipeline][exact]") {
  test::for_every_instruction_set([](InstructionSet set) {
    Pipeline pipeline({.threads = 2, .instruction_set = set});
    RenderTarget target = *RenderTarget::create({.width = 90, .height = 70, .stencil = true});
    const test::Mesh ball = test::sphere(10), all = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});
    PipelineState mark = test::seen_from({0, 0.5, 3}), fill;
    mark.blend.write = false;
    mark.depth = fill.depth = kDepthOff;
    mark.stencil = {.enabled = true, .front = {.reference = 5, .pass = StencilOperation::replace}, .back = {.reference = 5, .pass = StencilOperation::replace}};
    fill.stencil = {.enabled = true, .front = {.test = Compare::equal, .reference = 5}, .back = {.test = Compare::equal, .reference = 5}};
    REQUIRE(pipeline.draw(target, {.mesh = ball.view(), .program = flat(), .state = mark}).ok());
    REQUIRE(pipeline.draw(target, {.mesh = all.view(), .program = flat(), .state = fill}).ok());
    test::Studio plain({.width = 90, .height = 70});
    plain.draw(ball.view(), flat(), test::seen_from({0, 0.5, 3}));
    const Image<Rgba8> inside = target.colour_image(), outline = plain.picture().colour;
    CHECK(test::pixels_drawn(inside) > 500);
    for (int y = 0; y < 70; ++y)
      for (int x = 0; x < 90; ++x)
        if ((inside.at(x, y).a == 0) != (outline.at(x, y).a == 0)) FAIL("pixel (" << x << ", " << y << ")");
  });
}

TEST_CASE("fragment stages: a closed surface is entered as often as it is left", "[pipeline][exact]") {
  test::for_every_instruction_set([](InstructionSet set) {
    for (const int samples : {1, 4})
      for (const bool both : {true, false}) {
        Pipeline pipeline({.threads = 2, .instruction_set = set});
        RenderTarget target = *RenderTarget::create({.width = 90, .height = 70, .stencil = true, .samples = samples});
        PipelineState state = test::seen_from({0.3, 0.5, 3});
        state.depth = kDepthOff;
        state.blend.write = false;
        state.stencil.enabled = true;
        state.stencil.front.pass = StencilOperation::increment_wrap;
        if (both) state.stencil.back.pass = StencilOperation::decrement_wrap;
        const test::Mesh ball = test::sphere(14);
        REQUIRE(pipeline.draw(target, {.mesh = ball.view(), .program = flat(), .state = state}).ok());
        for (int s = 0; s < samples; ++s) {
          const Image<std::uint8_t> codes = target.sample_stencil_codes(s);
          const auto marked = std::count(codes.pixels().begin(), codes.pixels().end(), both ? 0 : 1);
          if (both) CHECK(marked == 90 * 70);
          else CHECK((marked > 500 && marked < 90 * 70));
        }
      }
  });
}

TEST_CASE("fragment stages: a pass that makes no colours makes no attributes", "[pipeline][exact]") {
  struct StrideCatcher : Observer {
    int stride = -1;
    void after(Stage stage, const Chunk& chunk) override {
      if (stage == Stage::vertex_attributes) stride = chunk.vertices.stride;
    }
  };
  const test::Mesh mesh = test::sphere(6);
  PipelineState state = test::seen_from({0, 0, 3});
  const auto drawn = [&](const FragmentProgram& program, Image<std::int32_t>& depths) {
    Pipeline pipeline;
    RenderTarget target = *RenderTarget::create(64, 48), watched = *RenderTarget::create(64, 48);
    StrideCatcher catcher;
    const DrawCall draw{.mesh = mesh.view(), .program = program, .state = state};
    REQUIRE(pipeline.draw(target, draw).ok());
    REQUIRE(pipeline.draw(watched, draw, catcher).ok());
    depths = target.depth_codes();
    CHECK(watched.depth_codes() == target.depth_codes());
    return catcher.stride;
  };
  const TexturedUniforms holes{.texture = test::texture_of(test::checkerboard(8, 2, {255, 255, 255, 255}, {0, 0, 0, 0})), .sampler = {}, .alpha_cutoff = 0.5f};
  Image<std::int32_t> with_colours, without, cut_out;
  CHECK(drawn(phong({}), with_colours) == vertex_stride(Attributes::position | Attributes::normal));
  state.blend.write = false;
  state.fog = {.mode = FogMode::exp};
  CHECK(drawn(phong({}), without) == 0);
  CHECK(without == with_colours);
  // Where alpha decides about depth, it is still made.
  CHECK(drawn(textured(holes, true), cut_out) == vertex_stride(Attributes::texcoord));
  CHECK(cut_out != with_colours);
}

TEST_CASE("fragment stages: linear fog that ends where it starts is a step", "[pipeline]") {
  test::for_every_instruction_set([](InstructionSet set) {
    // Three points before, in and behind the step; a white fragment, black fog.
    const std::vector<ScreenVertex> points{{128, 128}, {384, 128}, {640, 128}};
    const std::vector<float> coordinates{0.75f, 1.0f, 1.25f};
    DrawCall draw{.mesh = {.screen_positions = points, .fog_coordinates = coordinates}, .program = flat(), .state = {}};
    draw.state.assembly.topology = Topology::points;
    draw.state.fog = {.mode = FogMode::linear, .start = 1, .end = 1};
    Pipeline pipeline({.threads = 1, .instruction_set = set});
    RenderTarget target = *RenderTarget::create(3, 1);
    REQUIRE(pipeline.draw(target, draw).ok());
    const Image<Rgba8> image = target.colour_image();
    CHECK((image.at(0, 0).r == 255 && image.at(1, 0).r == 0 && image.at(2, 0).r == 0));
  });
}

}  // namespace tuberia
