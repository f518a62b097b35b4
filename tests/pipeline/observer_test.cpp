#include <catch2/catch.hpp>

#include <algorithm>

#include "pipeline/pixel_recorder.hpp"
#include "pipeline/primitive_recorder.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {
namespace {

/// Notes which stages told of themselves, and that a block never gains a fragment.
class StageCounter : public Observer {
 public:
  void begin(const DrawCall&, const AcceptedDraw&) override { ++begun; }
  void after(Stage stage, const Chunk&) override { ++told[static_cast<std::size_t>(stage)]; }
  void before(Stage, const Chunk&, const FragmentBlock& block, const Tile&) override { live = block.live; }
  void after(Stage stage, const Chunk&, const FragmentBlock& block, const Tile& tile) override {
    ++told[static_cast<std::size_t>(stage)];
    if (stage != Stage::rasterization && (block.live & ~live) != 0) gained = true;
    if (block.left < tile.left || block.top < tile.top) misplaced = true;
  }
  void end(const DrawStatistics& all) override { statistics = all; }

  std::array<int, 16> told{};
  std::uint64_t live = 0;
  int begun = 0;
  bool gained = false, misplaced = false;
  DrawStatistics statistics;
};

/// A square over the whole target at a depth, in clip space with w = 1.
test::Mesh layer(float depth, glm::vec4 colour) {
  return test::rectangle({-1, -1, 2 * depth - 1}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, 1, colour);
}

FragmentProgram cut_out_program(std::uint8_t alpha) {
  const Image<Rgba8> image(1, 1, {255, 255, 0, alpha});
  return textured({.texture = test::texture_of(image), .sampler = {}, .alpha_cutoff = 0.5f}, true);
}

/// Five layers over one pixel: kept, kept, dropped by its alpha (by the state's alpha test or by the
/// program), hidden, blended.
void draw_five_layers(test::Studio& studio, bool by_alpha_test) {
  PipelineState state, testing;
  testing.alpha_test = {.test = Compare::greater_equal, .reference = 0.5f};
  studio.draw(layer(0.75f, {1, 0, 0, 1}).view(), gouraud(), state);
  studio.draw(layer(0.5f, {0, 1, 0, 1}).view(), gouraud(), state);
  if (by_alpha_test) studio.draw(layer(0.25f, {1, 1, 0, 64 / 255.0f}).view(), gouraud(), testing);
  else studio.draw(layer(0.25f, glm::vec4(1)).view(), cut_out_program(64), state);
  studio.draw(layer(0.625f, {0, 0, 1, 1}).view(), gouraud(), state);
  state.blend.mode = BlendMode::source_over;
  studio.draw(layer(0.375f, {1, 1, 1, 0.5f}).view(), gouraud(), state);
}

test::Mesh cut_triangle() {
  test::Mesh mesh = test::unit_vectors();
  mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}};
  mesh.colours.assign(3, glm::vec4(1));
  return mesh;
}

PipelineState cut_state() {
  PipelineState state;  // the third corner lies behind the eye
  state.transform.clip_from_world = test::clip_from_unit_vectors({{-1, -1, 0.5f, 1.5f}, {1.5f, -1, 0.25f, 2}, {0.25f, 0.5f, -3, -2}});
  return state;
}

}  // namespace

TEST_CASE("observer: a watched draw leaves the same bits", "[pipeline][exact]") {
  for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::srgb8, ColourFormat::rgba32f})
    for (const DepthFormat depth : {DepthFormat::d24, DepthFormat::d32f}) {
      const test::Canvas canvas{.width = 150, .height = 110, .colour = format, .depth = depth};
      test::Studio alone(canvas), watched(canvas);
      test::draw_everything(alone, 150.0f / 110);

      StageCounter counter;
      PixelRecorder pixel(watched.target(), 75, 60);
      PrimitiveRecorder primitive(3);
      Observers all({&counter, &pixel, &primitive});
      watched.watch(all);
      test::draw_everything(watched, 150.0f / 110);
      CHECK(watched.digest() == alone.digest());
      CHECK(counter.begun > 4);
      CHECK(!counter.gained);
      CHECK(!counter.misplaced);
      CHECK(counter.told[static_cast<std::size_t>(Stage::binning)] > 0);
      CHECK(counter.told[static_cast<std::size_t>(Stage::blending)] > 0);
    }
}

TEST_CASE("observer: the history of a pixel tells each fragment's fate in order", "[pipeline][exact]") {
  for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::srgb8, ColourFormat::rgba32f, ColourFormat::rgba16f})
  for (const bool by_alpha_test : {false, true}) {
    test::Studio studio({.width = 100, .height = 70, .colour = format, .background = {0, 0, 0, 1}});
    PixelRecorder recorder(studio.target(), 70, 30);
    studio.watch(recorder);
    draw_five_layers(studio, by_alpha_test);

    const PixelHistory history = recorder.history();
    REQUIRE(history.draws.size() == 5);
    REQUIRE(history.fragments.size() == 5);
    CHECK(history.initial[0].colour == Rgba32F{0, 0, 0, 1});
    CHECK(history.initial[0].depth == 16777215);
    const std::optional<Stage> died[5] = {{}, {}, by_alpha_test ? Stage::alpha_test : Stage::fragment_shading, Stage::depth_test, {}};
    const std::int32_t depth_left[5] = {12582911, 8388608, 8388608, 8388608, 6291456};
    SampleContents now = history.initial[0];
    for (int i = 0; i < 5; ++i) {
      INFO("layer " << i);
      const FragmentRecord& fragment = history.fragments[static_cast<std::size_t>(i)];
      CHECK(fragment.draw == i);
      CHECK(fragment.died_at() == died[i]);
      REQUIRE(fragment.samples.size() == 1);
      CHECK(fragment.samples[0].before == now);
      now = fragment.samples[0].after;
      CHECK(now.depth == depth_left[i]);
      if (died[i]) CHECK(now == fragment.samples[0].before);
      CHECK(fragment.weight[0] + fragment.weight[1] + fragment.weight[2] == Approx(1));
    }
    CHECK(now == pixel_contents(studio.target(), 70, 30)[0]);
    CHECK(history.fragments[2].colour->a == Approx(64 / 255.0));
    CHECK(history.draws[2].output.alpha_test.reference == (by_alpha_test ? 0.5f : 0.0f));
    CHECK(!history.fragments[2].samples[0].depth_code);   // alpha comes before a late depth test,
    CHECK(!history.fragments[3].colour);                  // and after an early one
    CHECK(*history.fragments[3].samples[0].depth_code > history.fragments[3].samples[0].before.depth);
  }
}

TEST_CASE("observer: the life of a clipped primitive adds up", "[pipeline][exact]") {
  test::Studio studio({.width = 200, .height = 130});
  PrimitiveRecorder recorder(0), elsewhere(1);
  Observers both({&recorder, &elsewhere});
  studio.watch(both);
  const test::Mesh mesh = cut_triangle();
  const DrawStatistics statistics = studio.draw(mesh.view(), gouraud(), cut_state());
  CHECK(!elsewhere.life().found);

  const PrimitiveLife& life = recorder.life();
  REQUIRE(life.found);
  REQUIRE(life.vertices.size() == 3);
  CHECK(life.vertices[1].object->value == glm::vec3(0, 1, 0));
  CHECK((life.vertices[2].outcode & outcode::behind) != 0);
  CHECK(life.clip == PrimitiveLife::Clip::cut);
  REQUIRE(life.corners.size() == 4);
  REQUIRE(life.pieces.size() == 2);
  CHECK(statistics.triangles_after_clipping == 2);
  for (const PrimitiveCorner& corner : life.corners) {
    CHECK(corner.weight[0] + corner.weight[1] + corner.weight[2] == Approx(1));
    if (corner.is_new) CHECK(corner.clip.z == -corner.clip.w);  // on the near plane exactly
    CHECK(corner.attributes == std::vector<float>(4, 1.0f));
  }

  const FragmentFates& fates = life.fates;
  CHECK(fates.covered == statistics.fragments);
  CHECK(fates.reached == statistics.samples_passed);
  CHECK(fates.covered == static_cast<std::int64_t>(life.fragments.size()));
  CHECK(fates.covered == fates.reached + fates.discarded + fates.failed_alpha + fates.failed_depth);
  CHECK(test::pixels_drawn(studio.picture().colour) == fates.reached);
  std::size_t tiles = 0;
  for (const PrimitivePiece& piece : life.pieces) {
    CHECK(piece.verdict == PrimitivePiece::Verdict::drawn);
    REQUIRE(piece.set_up.has_value());
    CHECK(piece.twice_area > 0);
    CHECK(piece.clockwise == piece.corner);
    tiles += piece.tiles.size();
  }
  CHECK(tiles > 1);
}

TEST_CASE("observer: outside its window a primitive's fragments are counted and not kept", "[pipeline]") {
  const test::Mesh mesh = cut_triangle();
  test::Studio studio({.width = 200, .height = 130});
  PrimitiveRecorder everything(0), window(0, {40, 105, 60, 125});
  Observers both({&everything, &window});
  studio.watch(both);
  const DrawStatistics statistics = studio.draw(mesh.view(), gouraud(), cut_state());
  const auto within = [](const FragmentRecord& f) { return f.x >= 40 && f.x < 60 && f.y >= 105 && f.y < 125; };
  const auto& all = everything.life().fragments;
  const auto expected = std::count_if(all.begin(), all.end(), within);
  CHECK(expected > 0);
  CHECK(expected < statistics.fragments);
  CHECK(window.life().fates.covered == statistics.fragments);
  CHECK(static_cast<std::ptrdiff_t>(window.life().fragments.size()) == expected);
  CHECK(std::all_of(window.life().fragments.begin(), window.life().fragments.end(), within));
}

TEST_CASE("observer: the life of a primitive that is not drawn says why", "[pipeline]") {
  const auto life_of = [](const test::ClipTriangle& triangle, CullFace cull) {
    test::Studio studio({.width = 64, .height = 64});
    PrimitiveRecorder recorder(0);
    studio.watch(recorder);
    PipelineState state;
    state.culling.cull = cull;
    state.transform.clip_from_world = test::clip_from_unit_vectors(triangle);
    studio.draw(test::unit_vectors().view(), flat(), state);
    return recorder.life();
  };
  using Verdict = PrimitivePiece::Verdict;
  const glm::vec4 a{-0.5f, -0.5f, 0, 1}, b{0.5f, -0.5f, 0, 1}, c{0, 0.5f, 0, 1};
  CHECK(life_of({a, b, c}, CullFace::back).pieces.at(0).verdict == Verdict::drawn);
  CHECK(life_of({a, c, b}, CullFace::back).pieces.at(0).verdict == Verdict::turned_away);
  // A triangle that came counter-clockwise is drawn the other way round.
  const PrimitivePiece front = life_of({a, b, c}, CullFace::back).pieces.at(0);
  CHECK(front.twice_area < 0);
  CHECK(front.clockwise == std::array<std::size_t, 3>{front.corner[0], front.corner[2], front.corner[1]});
  CHECK(life_of({a, b, c}, CullFace::front).pieces.at(0).verdict == Verdict::turned_away);
  CHECK(life_of({a, a, c}, CullFace::none).pieces.at(0).verdict == Verdict::no_area);
  CHECK(life_of({{0, 0, 0, 1}, {0.01f, 0, 0, 1}, {0, 0.01f, 0, 1}}, CullFace::none).pieces.at(0).verdict == Verdict::no_pixel_centre);
  CHECK(life_of({{0, 0, 2, 1}, {1, 0, 2, 1}, {0, 1, 2, 1}}, CullFace::none).clip == PrimitiveLife::Clip::outside);
}

TEST_CASE("observer: a pixel's history names the stencil test and every sample", "[pipeline][exact]") {
  RenderTarget target = *RenderTarget::create({.width = 40, .height = 40, .stencil = true, .samples = 4});
  Pipeline pipeline({.threads = 1});
  REQUIRE(target.clear({.colour = Rgba32F{0, 0, 0, 1}, .depth = 1.0f, .stencil = std::uint8_t{5}}, pipeline.workers()).ok());
  DrawCall draw;
  const test::Mesh whole = layer(0.5f, {1, 0, 0, 1});
  draw.program = gouraud();
  draw.mesh = whole.view();
  draw.state.stencil = {.enabled = true, .front = {.test = Compare::equal, .reference = 5, .pass = StencilOperation::increment}};
  draw.state.stencil.back = draw.state.stencil.front;
  PixelRecorder recorder(target, 20, 20);
  REQUIRE(pipeline.draw(target, draw, recorder).ok());
  REQUIRE(pipeline.draw(target, draw, recorder).ok());

  // The diagonal of the square goes through the pixel, so both triangles have some of its samples.
  const PixelHistory history = recorder.history();
  PixelContents now = history.initial;
  int lived = 0, died = 0;
  for (const FragmentRecord& fragment : history.fragments)
    for (const SampleRecord& sample : fragment.samples) {
      SampleContents& stored = now[static_cast<std::size_t>(sample.sample)];
      CHECK(sample.before == stored);
      stored = sample.after;
      CHECK(sample.stencil_failed == sample.died_at.has_value());
      (sample.died_at ? died : lived) += 1;
      CHECK(fragment.draw == (sample.died_at ? 1 : 0));
    }
  CHECK(lived == 4);
  CHECK(died == 4);
  CHECK(now == pixel_contents(target, 20, 20));
  CHECK(*now[0].stencil == 6);
}

TEST_CASE("observer: lines, points and polygons drawn as such have lives, too", "[pipeline]") {
  const test::Mesh mesh = cut_triangle();
  const auto life_of = [&](const MeshView& view, const PipelineState& state, std::int64_t& fragments) {
    test::Studio studio({.width = 120, .height = 90});
    PrimitiveRecorder recorder(0);
    studio.watch(recorder);
    fragments = studio.draw(view, gouraud(), state).fragments;
    return recorder.life();
  };
  PipelineState line = cut_state(), point = cut_state(), outlined = cut_state();
  line.assembly.topology = Topology::lines;
  point.assembly.topology = Topology::points;
  outlined.rasterization.front_mode = outlined.rasterization.back_mode = PolygonMode::line;
  std::int64_t fragments = 0;

  const PrimitiveLife of_line = life_of(mesh.view(), line, fragments);
  REQUIRE(of_line.pieces.size() == 1);
  CHECK(of_line.vertices.size() == 2);
  CHECK(of_line.pieces[0].corner_count == 2);
  CHECK(of_line.pieces[0].shape->kind == ScreenShape::Kind::line);
  CHECK(of_line.corners[1].attributes.size() == 4);
  CHECK(fragments > 50);
  CHECK(of_line.fates.covered == fragments);

  const PrimitiveLife of_point = life_of(mesh.view(), point, fragments);
  REQUIRE(of_point.pieces.size() == 1);
  CHECK(of_point.pieces[0].corner_count == 1);
  CHECK(of_point.fates.covered == 1);

  // Two triangles of the fan become three lines; the one that the near plane cut is no edge.
  const PrimitiveLife of_outline = life_of(mesh.view(), outlined, fragments);
  REQUIRE(of_outline.pieces.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(of_outline.pieces[i].corner_count == (i < 2 ? 3 : 2));
    CHECK(of_outline.pieces[i].set_up.has_value() == (i >= 2));
    CHECK((of_outline.pieces[i].verdict == PrimitivePiece::Verdict::drawn_as_others) == (i < 2));
  }
  CHECK(of_outline.fates.covered == fragments);
}

TEST_CASE("observer: a face that is turned away is told with its own colours", "[pipeline]") {
  test::Mesh mesh = test::unit_vectors();
  mesh.colours.assign(3, {1, 0, 0, 1});
  const std::vector<glm::vec4> back(3, {0, 0, 1, 1});
  MeshView view = mesh.view();
  view.back_colours = back;
  PipelineState state;
  state.transform.two_sided_colours = true;
  state.transform.clip_from_world = test::clip_from_unit_vectors({{-0.5f, -0.5f, 0, 1}, {0, 0.5f, 0, 1}, {0.5f, -0.5f, 0, 1}});
  for (const Winding front : {Winding::clockwise, Winding::counter_clockwise}) {
    state.culling.front_face = front;
    test::Studio studio({.width = 64, .height = 64});
    PrimitiveRecorder recorder(0);
    studio.watch(recorder);
    studio.draw(view, gouraud(), state);
    const PrimitiveLife& life = recorder.life();
    const bool is_front = front == Winding::clockwise;
    REQUIRE(life.pieces.size() == 1);
    CHECK(life.pieces[0].is_front == is_front);
    CHECK(life.pieces[0].set_up.has_value());
    CHECK(life.corners[0].attributes == (is_front ? std::vector<float>{1, 0, 0, 1} : std::vector<float>{0, 0, 1, 1}));
    REQUIRE(!life.fragments.empty());
    CHECK(life.fragments[0].is_back != is_front);
    CHECK(life.fragments[0].vertex[0] == 0);
  }
}

}  // namespace tuberia
