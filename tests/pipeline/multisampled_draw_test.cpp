#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/support/draws.hpp"
#include "tests/support/every_instruction_set.hpp"

namespace tuberia {

namespace {

/// A jittered grid of triangles that hides the whole target and reaches beyond it.
test::Mesh jittered_grid(std::uint64_t seed, int cells) {
  test::Random random(seed);
  test::Mesh mesh;
  const float step = 2.5f / static_cast<float>(cells);
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x)
      mesh.positions.push_back({-1.25f + step * (static_cast<float>(x) + random.between(-0.2f, 0.2f)),
                                -1.25f + step * (static_cast<float>(y) + random.between(-0.2f, 0.2f)), random.between(-1, 1)});
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      const auto a = static_cast<std::uint32_t>(y * (cells + 1) + x), b = a + 1, c = a + static_cast<std::uint32_t>(cells) + 1, d = c + 1;
      for (const std::uint32_t corner : {a, b, d, a, d, c}) mesh.indices.push_back(corner);
    }
  return mesh;
}

}  // namespace

TEST_CASE("multisampling: a mesh that hides the target draws every sample once", "[pipeline][exact]") {
  for (const int samples : {1, 2, 4, 8, 16})
    for (const int cells : {3, 40, 130}) {  // down to triangles that hold samples and no centre
      const test::Mesh mesh = jittered_grid(371, cells);
      for (const InstructionSet set : supported_instruction_sets()) {
        INFO(samples << " samples, " << cells << " cells, " << name_of(set) << ", seed 371");
        Pipeline pipeline({.threads = 2, .instruction_set = set});
        RenderTarget target = *RenderTarget::create({.width = 90, .height = 70, .colour = ColourFormat::rgba16f, .samples = samples});
        PipelineState state;
        state.depth = kDepthOff;
        state.blend.mode = BlendMode::additive;
        const auto drawn = pipeline.draw(target, {.mesh = mesh.view(), .program = flat(), .state = state, .count_fragments = true});
        REQUIRE(drawn.ok());
        CHECK(drawn->samples_passed == 90 * 70 * samples);
        for (int s = 0; s < samples; ++s) CHECK(target.sample_linear_image(s) == Image<Rgba32F>(90, 70, {1, 1, 1, 1}));
      }
    }
}

TEST_CASE("multisampling: an edge is as bright as it covers", "[pipeline][exact]") {
  // The left part of the target, up to 20.25 pixels.
  const test::Mesh part = test::rectangle({-1, -1, 0}, {2 * 20.25f / 32, 0, 0}, {0, 2, 0}, {0, 0, 1});
  for (const int samples : {2, 4, 8, 16}) {
    Pipeline pipeline({.threads = 1});
    RenderTarget target = *RenderTarget::create({.width = 32, .height = 8, .samples = samples});
    REQUIRE(pipeline.draw(target, {.mesh = part.view(), .program = flat(), .state = {}}).ok());
    int covered = 0;
    for (const SamplePosition& at : sample_positions(samples)) covered += at.x < -4;  // x = 20.25 is not in the left part
    const auto code = static_cast<std::uint8_t>((2 * 255 * covered + samples) / (2 * samples));
    for (int y = 0; y < 8; ++y) {
      CHECK(target.colour_image().at(19, y) == Rgba8{255, 255, 255, 255});
      CHECK(target.colour_image().at(20, y) == Rgba8{code, code, code, code});
      CHECK(target.colour_image().at(21, y) == Rgba8{0, 0, 0, 0});
    }
  }
}

TEST_CASE("multisampling: planes that cross each other are told apart sample by sample", "[pipeline][exact]") {
  // Two planes that meet in a steep line; with samples, its pixels are mixed.
  const auto drawn = [](int samples, bool first_in_front) {
    Pipeline pipeline({.threads = 1});
    RenderTarget target = *RenderTarget::create({.width = 64, .height = 64, .samples = samples});
    test::Mesh red = test::rectangle({-1, -1, -0.5123f}, {2, 0, 1}, {0, 2, 0.3f}, {0, 0, 1}, 1, {1, 0, 0, 1});
    test::Mesh blue = test::rectangle({-1, -1, 0.5f}, {2, 0, -1}, {0, 2, 0}, {0, 0, 1}, 1, {0, 0, 1, 1});
    if (!first_in_front) std::swap(red, blue);
    for (const test::Mesh* mesh : {&red, &blue})
      REQUIRE(pipeline.draw(target, {.mesh = mesh->view(), .program = gouraud(), .state = {}}).ok());
    return target.colour_image();
  };
  for (const int samples : {1, 4, 16}) {
    const Image<Rgba8> image = drawn(samples, true);
    CHECK(image == drawn(samples, false));  // whatever the order
    const auto mixed = std::count_if(image.pixels().begin(), image.pixels().end(), [](const Rgba8& p) { return p.r != 0 && p.b != 0; });
    CHECK((mixed > 20) == (samples > 1));
  }
}

TEST_CASE("fog: its coordinate is the mesh's own, or else clip w", "[pipeline]") {
  PipelineState state;
  state.fog = {.mode = FogMode::linear, .colour = {0, 0, 1, 1}, .start = 0, .end = 8};
  test::Mesh mesh = test::rectangle({-8, -8, -2}, {16, 0, 0}, {0, 16, 0}, {0, 0, 1});
  state.transform.clip_from_world = test::clip_from_world({0, 0, 2}, 1);  // 4 before the rectangle
  const std::vector<float> coordinates(4, -6.0f);
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (const bool own : {false, true}) {
      test::Studio studio({.width = 16, .height = 16, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set, .precision = precision}});
      MeshView view = mesh.view();
      if (own) view.fog_coordinates = coordinates;
      studio.draw(view, flat(), state);
      const Image<Rgba32F> image = studio.picture().linear;
      for (const Rgba32F& pixel : image.pixels()) {
        CHECK(pixel.r == Approx(own ? 0.25 : 0.5).epsilon(1e-5));
        CHECK(pixel.b == Approx(1));
        CHECK(pixel.a == 1);
      }
    }
  });
}

}  // namespace tuberia
