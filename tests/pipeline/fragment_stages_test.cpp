#include <catch2/catch.hpp>

#include <map>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {

namespace {

/// Of every sample's colour, depth and stencil code.
std::string digest_of_samples(const RenderTarget& target) {
  test::Sha256 sha;
  for (int s = 0; s < target.samples(); ++s) {
    sha.add(std::as_bytes(target.sample_linear_image(s).pixels()));
    sha.add(std::as_bytes(target.sample_depth_codes(s).pixels()));
    sha.add(std::as_bytes(target.sample_stencil_codes(s).pixels()));
  }
  return sha.hex();
}

struct NamedDraw {
  const char* name;
  test::Mesh mesh;
  FragmentProgram program;
  PipelineState state;
};

PipelineState seen_from(glm::dvec3 eye) {
  PipelineState state;
  state.transform.clip_from_world = test::clip_from_world(eye, 1.3);
  return state;
}

/// What the fused tile loops can draw, a bit of everything.
std::vector<NamedDraw> everyday_draws() {
  const PipelineState plain = seen_from({1.5, 1.25, 2.5});
  PipelineState lit = plain, over = plain, added = plain, untested = plain, depth_only = plain;
  lit.transform.vertex_lighting = Lighting{.specular = glm::vec3(0.4f), .eye = {1.5f, 1.25f, 2.5f}};
  over.blend.mode = BlendMode::source_over;
  over.rasterization.scissor = PixelRect{5, 3, 88, 61};
  added.blend.mode = BlendMode::additive;
  added.depth.test = Compare::less_equal;
  untested.depth = kDepthOff;
  depth_only.blend.write = false;
  const Image<Rgba8> holes = test::checkerboard(32, 4, {200, 30, 60, 255}, {0, 0, 0, 0});
  const TexturedUniforms texture{.texture = test::texture_of(holes, TextureEncoding::srgb), .sampler = {}, .alpha_cutoff = 0.5f};
  const test::Mesh floor = test::rectangle({-9, -1, -9}, {0, 0, 18}, {18, 0, 0}, {0, 1, 0}, 7);
  return {{"depth only", test::rectangle({-1, -1, 0.5f}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}), flat(), depth_only},
          {"cut out", floor, textured(texture, true), plain},
          {"gouraud", test::sphere(12), gouraud(), lit},
          {"phong, added", test::sphere(9), phong({}), added},
          {"flat, over", test::sphere(7), flat(), over},
          {"textured, untested", floor, textured(texture), untested}};
}

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
        for (const NamedDraw& one : everyday_draws()) {
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
  const NamedDraw ball = everyday_draws()[2];
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

/// State that only the staged loops know, all of it in use somewhere.
std::vector<NamedDraw> staged_draws(bool logic) {
  std::vector<NamedDraw> draws = everyday_draws();
  for (std::size_t i = 0; i < draws.size(); ++i) {
    PipelineState& state = draws[i].state;
    const auto pick = [&](std::size_t n, std::size_t step) { return (i * step + 3) % n; };
    state.stencil.enabled = true;
    state.stencil.front = {.test = i % 2 == 0 ? Compare::always : Compare::not_equal, .reference = static_cast<std::uint8_t>(i), .read_mask = 0x0f,
                           .write_mask = 0x3f, .fail = StencilOperation::invert, .depth_fail = StencilOperation::increment_wrap,
                           .pass = static_cast<StencilOperation>(pick(8, 3))};
    state.stencil.back = state.stencil.front;
    state.blend.mode = BlendMode::function;
    state.blend.colour = {static_cast<BlendFactor>(pick(15, 4)), static_cast<BlendFactor>(pick(15, 7)), static_cast<BlendEquation>(pick(5, 1))};
    state.blend.alpha = {BlendFactor::one, BlendFactor::one_minus_source_alpha, BlendEquation::add};
    state.blend.constant = {0.5f, 0.25f, 0.75f, 0.5f};
    state.blend.mask = {true, i != 3, true, i != 4};
    state.alpha_test = {Compare::greater, 0.125f};
    state.multisampling.alpha_to_coverage = i == 1;
    state.fog = {.mode = static_cast<FogMode>(pick(4, 1)), .colour = {0.5f, 0.6f, 0.7f, 1}, .density = 0.2f, .start = 1, .end = 9};
    if (logic && i >= 3) state.blend.logic = static_cast<LogicOperation>(1 + pick(16, 5));
  }
  return draws;
}

std::string digest_of_staged(ColourFormat format, int samples, int threads, InstructionSet set) {
  Pipeline pipeline({.threads = threads, .instruction_set = set});
  RenderTarget target = *RenderTarget::create({.width = 133, .height = 90, .colour = format, .stencil = true, .samples = samples});
  pipeline.clear(target, {0.2f, 0.3f, 0.4f, 1});
  for (const NamedDraw& one : staged_draws(format == ColourFormat::rgba8)) {
    const auto drawn = pipeline.draw(target, {.mesh = one.mesh.view(), .program = one.program, .state = one.state});
    if (!drawn) FAIL(one.name << " was refused: " << drawn.error().message);
  }
  return digest_of_samples(target);
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

}  // namespace tuberia
