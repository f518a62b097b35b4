#include <catch2/catch.hpp>

#include "pipeline/primitive_assembly.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"
#include "tests/support/render.hpp"

namespace tuberia {

namespace {

ScreenVertex at_pixels(double x, double y, float depth = 0.5f) {
  return {.x = static_cast<std::int32_t>(std::lround(x * 256)), .y = static_cast<std::int32_t>(std::lround(y * 256)), .depth = depth};
}

/// Adds one code for each fragment, so that a picture shows how often its pixels were drawn.
PipelineState counting(Topology topology) {
  PipelineState state;
  state.assembly.topology = topology;
  state.depth = kDepthOff;
  state.blend.mode = BlendMode::additive;
  return state;
}

Image<Rgba8> drawn_on_screen(const std::vector<ScreenVertex>& vertices, const PipelineState& state, const test::Canvas& canvas = {}) {
  test::Studio studio(canvas);
  const std::vector<glm::vec4> colours(vertices.size(), glm::vec4(1.0f / 255));
  studio.draw({.screen_positions = vertices, .colours = colours}, gouraud(), state);
  return studio.picture().colour;
}

std::int64_t most_often(const Image<Rgba8>& image) {
  std::int64_t most = 0;
  for (const Rgba8& p : image.pixels()) most = std::max<std::int64_t>(most, p.r);
  return most;
}

std::vector<std::array<std::uint32_t, 2>> ends_of(Topology topology, std::vector<std::uint32_t> slots, PrimitiveRange range) {
  LineBatch batch;
  PrimitiveAssembly({topology})(slots, range, batch);
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (const AssembledLine& line : batch) {
    ends.push_back({line.v0, line.v1});
    CHECK(line.provoking == line.v0);
    CHECK(line.primitive == range.first + static_cast<std::int64_t>(ends.size()) - 1);
  }
  return ends;
}

/// Everything that lines and points have: widths, patterns, clipping, blending, more than a chunk.
std::string digest_of_shapes(Topology topology, const PipelineOptions& options) {
  test::Random random(81);
  std::vector<glm::vec4> positions, colours;
  for (int i = 0; i < 5001; ++i) {
    positions.push_back({random.between(-1.2f, 1.2f), random.between(-1.2f, 1.2f), random.between(-1.1f, 1.1f), random.between(-0.1f, 2)});
    colours.push_back({random.between(0, 1), random.between(0, 1), random.between(0, 1), random.between(0, 0.5f)});
  }
  PipelineState state;
  state.assembly.topology = topology;
  state.blend.mode = BlendMode::source_over;
  state.rasterization.line = {.width_pixels = 2, .stipple = StipplePattern{0x3c5f, 2}};
  state.rasterization.point = {.size_pixels = 5.5f, .round = true};
  test::Studio studio({.width = 150, .height = 130, .options = options});
  studio.draw({.clip_positions = positions, .colours = colours}, gouraud(), state);
  return studio.digest();
}

}  // namespace

TEST_CASE("assembly: lines of lists, strips and loops", "[pipeline]") {
  using Ends = std::vector<std::array<std::uint32_t, 2>>;
  CHECK(ends_of(Topology::lines, {7, 6, 5, 4}, {3, 2}) == Ends{{7, 6}, {5, 4}});
  CHECK(ends_of(Topology::line_strip, {0, 1, 2}, {9, 2}) == Ends{{0, 1}, {1, 2}});
  for (const auto& [topology, elements, lines] :
       {std::tuple{Topology::lines, 5, 2}, {Topology::line_strip, 5, 4}, {Topology::line_strip, 1, 0}, {Topology::line_loop, 5, 5},
        {Topology::line_loop, 2, 2}, {Topology::line_loop, 1, 0}, {Topology::points, 3, 3}})
    CHECK(primitive_count(topology, elements) == lines);

  // A loop's last line returns to its first vertex, in whatever chunk.
  const std::vector<glm::vec3> positions(4);
  const MeshView mesh{.positions = positions};
  VertexFetch fetch;
  VertexBatch batch;
  std::vector<std::uint32_t> slots;
  fetch(mesh, Topology::line_loop, {2, 2}, batch, slots);
  CHECK(batch.source == std::vector<std::uint32_t>{2, 3, 0});
  CHECK(ends_of(Topology::line_loop, slots, {2, 2}) == Ends{{0, 1}, {1, 2}});
  fetch(mesh, Topology::line_loop, {0, 2}, batch, slots);
  CHECK(batch.source == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("lines: a closed square loop draws each of its pixels once", "[pipeline][exact]") {
  const std::vector<ScreenVertex> square{at_pixels(10.5, 10.5), at_pixels(50.5, 10.5), at_pixels(50.5, 40.5), at_pixels(10.5, 40.5)};
  const Image<Rgba8> image = drawn_on_screen(square, counting(Topology::line_loop));
  CHECK(most_often(image) == 1);
  CHECK(test::pixels_drawn(image) == 2 * (40 + 30));
}

TEST_CASE("lines: a strip along any staircase draws its joints once", "[pipeline][exact]") {
  test::Random random(82);
  for (int round = 0; round < 200; ++round) {
    // Always to the right and never steep, so only joints could be drawn twice.
    std::vector<ScreenVertex> strip{at_pixels(2.3, 32)};
    while (strip.back().x < 60 * 256) {
      const auto dx = static_cast<std::int32_t>(1 + random.below(900)), dy = static_cast<std::int32_t>(random.below(2 * dx + 1) - dx);
      strip.push_back({.x = strip.back().x + dx, .y = std::clamp(strip.back().y + dy, 1000, 15000), .depth = 0.5f});
    }
    INFO("seed 82, strip " << round);
    CHECK(most_often(drawn_on_screen(strip, counting(Topology::line_strip))) == 1);
  }
}

TEST_CASE("lines: more than one chunk of a strip stipples like one long line", "[pipeline][exact]") {
  std::vector<ScreenVertex> strip;
  for (int i = 0; i <= 5000; ++i) strip.push_back(at_pixels(1.5 + i * 60.0 / 5000, 20.5));
  PipelineState state = counting(Topology::line_strip);
  for (const StipplePattern& pattern : {StipplePattern{0x0f35, 1}, {0x0f35, 3}, {0x5555, 2}}) {
    state.rasterization.line.stipple = pattern;
    for (const int threads : {1, 2, 7})
      CHECK(drawn_on_screen(strip, state, {.options = {.threads = threads}}) == drawn_on_screen({strip.front(), strip.back()}, state));
  }
  // Lists begin anew with each line, so there the pattern's first bit is all that is seen.
  state.rasterization.line.stipple = StipplePattern{0xfffe, 256};
  state.assembly.topology = Topology::lines;
  CHECK(test::pixels_drawn(drawn_on_screen(strip, state)) == 0);
}

TEST_CASE("lines: the pattern goes on after hundreds of chunks", "[pipeline][exact]") {
  // Three pixels forth and three back, then a line where it shows.
  const auto picture = [](int lines) {
    std::vector<ScreenVertex> strip;
    for (int i = 0; i <= lines; ++i) strip.push_back(at_pixels(i % 2 == 0 ? 0.5 : 3.5, 2.5));
    strip.push_back(at_pixels(0.5, 12.5));
    strip.push_back(at_pixels(60.5, 12.5));
    PipelineState state = counting(Topology::line_strip);
    state.rasterization.line.stipple = StipplePattern{0x0b35, 2};
    state.rasterization.scissor = PixelRect{0, 12, 64, 13};
    return drawn_on_screen(strip, state);
  };
  constexpr int kPeriod = 32;  // lines of 3 pixels until 3 n is a multiple of 16 * 2
  CHECK(picture(kPeriod * 9000 + 10) == picture(10));
  CHECK(picture(11) != picture(10));
}

TEST_CASE("lines: those that are outside or not finite are dropped, others cut", "[pipeline]") {
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<glm::vec4> positions{{-0.5f, 0, 0, 1},  {0.5f, 0, 0, 1},    // inside
                                         {-0.5f, 0, -3, 1}, {0.5f, 0, -2, 1},   // before the near plane
                                         {0, 0, -3, 1},     {0, 0, 0.5f, 1},    // through it
                                         {0, inf, 0, 1},    {0, 0, 0, 1},       // nowhere
                                         {0, 0, 0, 0},      {0, 0, 0, 1},       // without a place
                                         {0.3f, 0.4f, 0.2f, -1}, {0, 0, 0, 1}}; // from behind the eye
  PipelineState state = counting(Topology::lines);
  test::Studio studio({});
  const DrawStatistics lines = studio.draw({.clip_positions = positions}, gouraud(), state);
  CHECK(lines.triangles_in == 6);
  CHECK(lines.triangles_clipped == 3);
  CHECK(lines.triangles_after_clipping == 3);
  CHECK(lines.triangles_drawn == 3);
  state.assembly.topology = Topology::points;
  const DrawStatistics points = studio.draw({.clip_positions = positions}, gouraud(), state);
  CHECK(points.triangles_in == 12);
  CHECK(points.triangles_clipped == 0);
  CHECK(points.triangles_after_clipping == 6);
}

TEST_CASE("lines: colours and depths run from end to end, flat ones stay with the first", "[pipeline]") {
  const std::vector<ScreenVertex> ends{at_pixels(0.5, 5.5, 0.25f), at_pixels(60.5, 5.5, 0.75f)};
  const std::vector<glm::vec4> colours{{1, 0, 0, 1}, {0, 0, 1, 1}};
  PipelineState state;
  state.assembly.topology = Topology::lines;
  const auto draw = [&] {
    test::Studio studio({.depth = DepthFormat::d16});
    studio.draw({.screen_positions = ends, .colours = colours}, gouraud(), state);
    return studio.picture();
  };
  const test::Picture smooth = draw();
  CHECK(smooth.colour.at(0, 5) == Rgba8{255, 0, 0, 255});
  CHECK(smooth.colour.at(30, 5) == Rgba8{128, 0, 128, 255});
  CHECK(smooth.depth.at(30, 5) == 32768);
  CHECK(smooth.depth.at(0, 5) == 16384);
  state.rasterization.flat_shading = true;
  CHECK(draw().colour.at(59, 5) == Rgba8{255, 0, 0, 255});
}

TEST_CASE("lines: one picture for all threads and instruction sets", "[pipeline][exact]") {
  for (const Topology topology : {Topology::lines, Topology::line_strip, Topology::line_loop, Topology::points}) {
    const std::string first = digest_of_shapes(topology, {.threads = 1});
    test::for_every_instruction_set([&](InstructionSet set) {
      for (const int threads : {1, 2, 7}) CHECK(digest_of_shapes(topology, {.threads = threads, .instruction_set = set}) == first);
    });
  }
}

TEST_CASE("lines: four scissored quadrants are the picture", "[pipeline][exact]") {
  test::Random random(83);
  std::vector<ScreenVertex> vertices;
  for (int i = 0; i < 300; ++i) vertices.push_back(at_pixels(static_cast<double>(random.between(-40, 180)), static_cast<double>(random.between(-40, 180))));
  for (const Topology topology : {Topology::line_strip, Topology::points}) {
    PipelineState state = counting(topology);
    state.rasterization.line = {.width_pixels = 3, .stipple = StipplePattern{0x00ff, 1}};
    state.rasterization.point = {.size_pixels = 33.3f, .round = true};
    const test::Canvas canvas{.width = 140, .height = 135};
    const Image<Rgba8> whole = drawn_on_screen(vertices, state, canvas);
    Image<Rgba8> parts(140, 135);
    for (const PixelRect& part : {PixelRect{0, 0, 67, 45}, {67, 0, 140, 45}, {0, 45, 67, 135}, {67, 45, 140, 135}}) {
      state.rasterization.scissor = part;
      const Image<Rgba8> one = drawn_on_screen(vertices, state, canvas);
      for (int y = part.top; y < part.bottom; ++y)
        for (int x = part.left; x < part.right; ++x) parts.at(x, y) = one.at(x, y);
      for (int y = 0; y < 135; ++y)
        for (int x = 0; x < 140; ++x)
          if (x < part.left || x >= part.right || y < part.top || y >= part.bottom) CHECK(one.at(x, y) == Rgba8{0, 0, 0, 0});
    }
    CHECK(parts == whole);
  }
}

TEST_CASE("multisampling: triangles round a point own each sample of the screen once", "[pipeline][exact]") {
  test::Random random(88);
  for (int round = 0; round < 12; ++round)
    for (const int samples : {2, 16}) {
      // A hub anywhere and a rim outside the screen; a ring of very small triangles around the hub.
      const std::int32_t x = static_cast<std::int32_t>(random.below(150 * 256)), y = static_cast<std::int32_t>(random.below(140 * 256));
      std::vector<ScreenVertex> vertices{{x, y, 0.5f, 1}};
      for (const int radius : {70, 400 * 256})
        for (int i = 0; i < 13; ++i) {
          const double angle = 6.283185307179586 * i / 13 + 0.1 * round;
          vertices.push_back({x + static_cast<std::int32_t>(std::lround(radius * std::cos(angle))),
                              y + static_cast<std::int32_t>(std::lround(radius * std::sin(angle))), 0.5f, 1});
        }
      std::vector<std::uint32_t> indices;
      for (std::uint32_t i = 0; i < 13; ++i) {
        const std::uint32_t a = 1 + i, b = 1 + (i + 1) % 13;
        for (const std::uint32_t index : {0u, a, b, a, a + 13, b, b, a + 13, b + 13}) indices.push_back(index);
      }
      Pipeline pipeline({.threads = 2});
      RenderTarget target = *RenderTarget::create({.width = 150, .height = 140, .samples = samples});
      const std::vector<glm::vec4> one(vertices.size(), glm::vec4(1.0f / 255));
      REQUIRE(pipeline.draw(target, {.mesh = {.screen_positions = vertices, .colours = one, .indices = indices}, .program = gouraud(),
                                     .state = counting(Topology::triangles)}).ok());
      INFO("seed 88, round " << round << ", " << samples << " samples");
      for (int s = 0; s < samples; ++s) {
        const Image<Rgba8> image = target.sample_colour_image(s);
        REQUIRE(std::all_of(image.pixels().begin(), image.pixels().end(), [](const Rgba8& p) { return p.r == 1; }));
      }
    }
}

}  // namespace tuberia
