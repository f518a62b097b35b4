#include "pipeline/polygon_modes.hpp"

#include <catch2/catch.hpp>

#include "pipeline/clipping.hpp"
#include "tests/support/random.hpp"
#include "tests/support/render.hpp"

namespace tuberia {

namespace {

/// Draws triangles of clip space, every fragment adding one code.
test::Picture outlined(const MeshView& mesh, PipelineState state) {
  state.depth = kDepthOff;
  state.blend.mode = BlendMode::additive;
  test::Studio studio({});
  const std::vector<glm::vec4> colours(mesh.vertex_count(), glm::vec4(1.0f / 255));
  MeshView coloured = mesh;
  coloured.colours = colours;
  studio.draw(coloured, gouraud(), state);
  return studio.picture();
}

PipelineState drawing(PolygonMode front, PolygonMode back) {
  PipelineState state;
  state.rasterization.front_mode = front;
  state.rasterization.back_mode = back;
  return state;
}

// A right angle on pixel centres of a 64x64 target: 40 pixels wide and high; seen from its front.
const std::vector<glm::vec4> kAngle{{-31.0f / 32 + 1.0f / 64, -0.5f - 1.0f / 64, 0, 1}, {0.25f + 3.0f / 64, -0.5f - 1.0f / 64, 0, 1}, {-31.0f / 32 + 1.0f / 64, 0.75f - 1.0f / 64, 0, 1}};

}  // namespace

TEST_CASE("polygon modes: edges are those whose flag is set", "[pipeline]") {
  const PipelineState state = drawing(PolygonMode::line, PolygonMode::line);
  const auto lines = [&](std::vector<std::uint8_t> flags) { return outlined({.clip_positions = kAngle, .edge_flags = flags}, state).statistics.triangles_drawn; };
  CHECK(lines({}) == 3);
  CHECK(lines({1, 1, 1}) == 3);
  CHECK(lines({1, 0, 7}) == 2);
  CHECK(lines({0, 0, 0}) == 0);
  // Only the edge that begins at vertex 0: a level line of 40 pixels.
  const std::vector<std::uint8_t> first{1, 0, 0};
  const Image<Rgba8> bottom = outlined({.clip_positions = kAngle, .edge_flags = first}, state).colour;
  CHECK(test::pixels_drawn(bottom) == 40);
  for (int x = 1; x < 41; ++x) CHECK(bottom.at(x, 48).r == 1);
  // Strips draw them all.
  PipelineState strip = state;
  strip.assembly.topology = Topology::triangle_strip;
  const std::vector<std::uint8_t> none{0, 0, 0};
  CHECK(outlined({.clip_positions = kAngle, .edge_flags = none}, strip).statistics.triangles_drawn == 3);
}

TEST_CASE("polygon modes: points stand where flagged edges begin", "[pipeline]") {
  const PipelineState state = drawing(PolygonMode::point, PolygonMode::point);
  const std::vector<std::uint8_t> flags{1, 0, 1};
  const Image<Rgba8> corners = outlined({.clip_positions = kAngle, .edge_flags = flags}, state).colour;
  CHECK(test::pixels_drawn(corners) == 2);
  CHECK(corners.at(1, 48).r == 1);
  CHECK(corners.at(1, 8).r == 1);
}

TEST_CASE("polygon modes: what clipping cut is no edge and no corner", "[pipeline]") {
  // Corner 0 is cut off, half way along its two edges.
  PipelineState state = drawing(PolygonMode::line, PolygonMode::line);
  state.clipping.user_plane_count = 1;
  state.clipping.user_planes[0] = {1, 1, 0, 0.5};
  const test::Picture lines = outlined({.clip_positions = kAngle}, state);
  CHECK(lines.statistics.triangles_clipped == 1);
  CHECK(lines.statistics.triangles_after_clipping == 2);
  CHECK(lines.statistics.triangles_drawn == 3);
  PipelineState whole = drawing(PolygonMode::line, PolygonMode::line);
  const Image<Rgba8> all = outlined({.clip_positions = kAngle}, whole).colour;
  CHECK(test::pixels_drawn(lines.colour) < test::pixels_drawn(all));
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      if (lines.colour.at(x, y).r != 0) CHECK(all.at(x, y).r != 0);
  state.rasterization.front_mode = state.rasterization.back_mode = PolygonMode::point;
  CHECK(outlined({.clip_positions = kAngle}, state).statistics.triangles_drawn == 2);
}

TEST_CASE("polygon modes: each face has its own, and is culled whole", "[pipeline]") {
  std::vector<glm::vec4> turned = kAngle;
  std::swap(turned[1], turned[2]);
  const auto pixels = [&](const std::vector<glm::vec4>& corners, PolygonMode front, PolygonMode back, CullFace cull) {
    PipelineState state = drawing(front, back);
    state.culling.cull = cull;
    return test::pixels_drawn(outlined({.clip_positions = corners}, state).colour);
  };
  const std::int64_t filled = pixels(kAngle, PolygonMode::fill, PolygonMode::fill, CullFace::none);
  CHECK(filled > 700);
  CHECK(pixels(kAngle, PolygonMode::fill, PolygonMode::point, CullFace::none) == filled);
  CHECK(pixels(kAngle, PolygonMode::point, PolygonMode::fill, CullFace::none) == 3);
  CHECK(pixels(turned, PolygonMode::fill, PolygonMode::point, CullFace::none) == 3);
  CHECK(pixels(turned, PolygonMode::point, PolygonMode::fill, CullFace::none) == filled);
  CHECK(pixels(turned, PolygonMode::fill, PolygonMode::line, CullFace::back) == 0);
  CHECK(pixels(kAngle, PolygonMode::line, PolygonMode::fill, CullFace::front) == 0);
  // Without area they count as turned away.
  std::vector<glm::vec4> flat = kAngle;
  flat[2] = flat[1];
  CHECK(pixels(flat, PolygonMode::fill, PolygonMode::line, CullFace::none) == 40 + 1);
  CHECK(pixels(flat, PolygonMode::line, PolygonMode::fill, CullFace::none) == 0);
}

TEST_CASE("polygon modes: filled polygons among others keep their order and their bits", "[pipeline][exact]") {
  test::Random random(84);
  std::vector<glm::vec4> positions, colours;
  for (int i = 0; i < 3 * 2500; ++i) {
    positions.push_back({random.between(-1.5f, 1.5f), random.between(-1.5f, 1.5f), random.between(-1.5f, 1.5f), random.between(0.2f, 2)});
    colours.push_back({random.between(0, 1), random.between(0, 1), random.between(0, 1), random.between(0, 0.6f)});
  }
  PipelineState state;
  state.blend.mode = BlendMode::source_over;
  state.culling.cull = CullFace::back;
  const auto digest = [&](PolygonMode back, bool only_front) {
    test::Studio studio({.width = 90, .height = 70});
    state.rasterization.back_mode = back;
    state.culling.cull = only_front ? CullFace::back : CullFace::none;
    studio.draw({.clip_positions = positions, .colours = colours}, gouraud(), state);
    return studio.digest();
  };
  CHECK(digest(PolygonMode::line, true) == digest(PolygonMode::fill, true));
  CHECK(digest(PolygonMode::line, false) != digest(PolygonMode::fill, false));
}

TEST_CASE("polygon modes: stippled edges start anew with each polygon", "[pipeline]") {
  PipelineState state = drawing(PolygonMode::line, PolygonMode::line);
  state.rasterization.line.stipple = StipplePattern{0x1f0d, 1};
  std::vector<glm::vec4> twice = kAngle;
  twice.insert(twice.end(), kAngle.begin(), kAngle.end());
  const Image<Rgba8> once = outlined({.clip_positions = kAngle}, state).colour, both = outlined({.clip_positions = twice}, state).colour;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) CHECK(both.at(x, y).r == 2 * once.at(x, y).r);
  // From the first edge to the second it goes on: 40 pixels after its beginning.
  const auto second = [&](int n) { return once.at(41 - n, 48 - n).r != 0; };
  for (int n = 0; n < 40; ++n) CHECK(second(n) == ((0x1f0d >> (40 + n) % 16 & 1) != 0));
}

// rules Z3, case 33
TEST_CASE("polygon offset: a slope and a unit", "[pipeline][case-33]") {
  const auto bias = [](const PolygonOffset& state, DepthFormat format, float at_origin) {
    VertexBatch batch;
    batch.screen = {{.depth = at_origin}, {.x = 100 * 256, .depth = at_origin + 0.1f}, {.y = 100 * 256, .depth = at_origin + 0.2f}};
    const PolygonOffsetting offset(state, format);
    CHECK(offset.bias(batch, 0, 1, 2) == offset.bias(batch, 0, 2, 1));
    return offset.bias(batch, 0, 1, 2);
  };
  const PolygonOffset state{.factor = 1.5f, .units = 4};
  CHECK(bias(state, DepthFormat::d24, 0.25f) == Approx(.0030002384185791016).epsilon(1e-6));
  CHECK(bias(state, DepthFormat::d16, 0.25f) == Approx(.00306103515625).epsilon(1e-6));
  CHECK(bias(state, DepthFormat::d32f, 0.55f) == Approx(.0030002384185791016).epsilon(1e-6));
  CHECK(bias({.factor = 0, .units = 4}, DepthFormat::d16, 0.25f) == 4.0 / 65536);
  CHECK(bias({.factor = 0, .units = -1}, DepthFormat::d32f, 0.25f) == -0x1p-25);
  CHECK(bias({.factor = 0, .units = 1}, DepthFormat::d32f, -0.2f) == 0x1p-26);
  CHECK(bias({.factor = 1.5f, .units = 4, .clamp = 0.001f}, DepthFormat::d24, 0.25f) == static_cast<double>(0.001f));
  CHECK(bias({.factor = -1.5f, .units = 0, .clamp = -0.001f}, DepthFormat::d24, 0.25f) == static_cast<double>(-0.001f));
}

TEST_CASE("polygon offset: decides between equal depths, in the modes that it is meant for", "[pipeline]") {
  for (const PolygonMode mode : {PolygonMode::fill, PolygonMode::line, PolygonMode::point})
    for (const bool applies : {true, false}) {
      test::Studio studio({});
      PipelineState state = drawing(mode, mode);
      studio.draw({.clip_positions = kAngle}, gouraud(), state);
      const std::int64_t all = test::pixels_drawn(studio.picture().colour);
      state.rasterization.polygon_offset = {.factor = 0, .units = -2, .fill = applies, .line = applies, .point = applies};
      const std::vector<glm::vec4> red(3, {1, 0, 0, 1});
      studio.draw({.clip_positions = kAngle, .colours = red}, gouraud(), state);
      const auto image = studio.picture().colour;
      CHECK(std::count(image.pixels().begin(), image.pixels().end(), Rgba8{255, 0, 0, 255}) == (applies ? all : 0));
    }
}

TEST_CASE("two-sided colours: what is turned away takes the others", "[pipeline]") {
  std::vector<glm::vec4> both = kAngle;
  for (const int i : {0, 2, 1}) both.push_back(kAngle[static_cast<std::size_t>(i)] * glm::vec4(-1, -1, 1, 1));
  const std::vector<glm::vec4> front(6, {0, 1, 0, 1}), back(6, {0, 0, 1, 1});
  const std::vector<glm::vec3> normals(6, {0, 0, 1});
  const auto colours = [&](const PipelineState& state, const MeshView& mesh) {
    test::Studio studio({});
    studio.draw(mesh, gouraud(), state);
    const Image<Rgba8> image = studio.picture().colour;
    return std::pair{image.at(2, 47), image.at(61, 16)};
  };
  for (const PolygonMode mode : {PolygonMode::fill, PolygonMode::line}) {
    PipelineState state = drawing(mode, mode);
    state.rasterization.line.width_pixels = 5;
    const MeshView mesh{.clip_positions = both, .normals = normals, .colours = front, .back_colours = back};
    CHECK(colours(state, mesh) == std::pair{Rgba8{0, 255, 0, 255}, Rgba8{0, 255, 0, 255}});
    state.transform.two_sided_colours = true;
    CHECK(colours(state, mesh) == std::pair{Rgba8{0, 255, 0, 255}, Rgba8{0, 0, 255, 255}});
    // Cut by a plane, which makes vertices of both kinds.
    state.clipping.user_plane_count = 1;
    state.clipping.user_planes[0] = {0, 0, 0.1, 0.05};
    CHECK(colours(state, mesh) == std::pair{Rgba8{0, 255, 0, 255}, Rgba8{0, 0, 255, 255}});
    // One light before both: the back's normals are turned away from it.
    state.transform.vertex_lighting = Lighting{.ambient = glm::vec3(0), .diffuse = glm::vec3(1)};
    CHECK(colours(state, {.clip_positions = both, .normals = normals}) == std::pair{Rgba8{255, 255, 255, 255}, Rgba8{0, 0, 0, 255}});
    state.transform.back_lighting = Lighting{.ambient = {1, 0, 0}, .diffuse = glm::vec3(0)};
    CHECK(colours(state, {.clip_positions = both, .normals = normals}) == std::pair{Rgba8{255, 255, 255, 255}, Rgba8{255, 0, 0, 255}});
    state.rasterization.flat_shading = true;
    CHECK(colours(state, {.clip_positions = both, .normals = normals}).second == Rgba8{255, 0, 0, 255});
  }
}

TEST_CASE("clipping: a plane and its negation share the screen exactly", "[pipeline][exact]") {
  test::Random random(85);
  const std::vector<glm::vec4> screen{{-3, -3, 0, 1}, {5, -3, 0, 1}, {-3, 5, 0, 1}, {5, 5, 0, 1}};
  const std::vector<glm::vec4> one(4, glm::vec4(1.0f / 255));
  for (int i = 0; i < 100; ++i) {
    INFO("seed 85, plane " << i);
    test::Studio studio({});
    PipelineState state;
    state.depth = kDepthOff;
    state.blend.mode = BlendMode::additive;
    state.assembly.topology = Topology::triangle_strip;
    state.clipping.user_plane_count = 1;
    const glm::dvec4 plane(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(-0.5f, 0.5f));
    for (const double sign : {1.0, -1.0}) {
      state.clipping.user_planes[0] = sign * plane;
      studio.draw({.clip_positions = screen, .colours = one}, gouraud(), state);
    }
    const Image<Rgba8> image = studio.picture().colour;
    for (const Rgba8& p : image.pixels()) REQUIRE(p.r == 1);
  }
}

TEST_CASE("clipping: eight user planes and six others leave seventeen corners at most", "[pipeline]") {
  test::Random random(86);
  const ClipLimits tight{.guard_x = 1, .guard_y = 1, .z_low = -1};
  int most = 0;
  for (int i = 0; i < 3000; ++i) {
    ClipLimits limits = tight;
    limits.user_plane_count = 8;
    for (auto& plane : limits.user_planes) {
      // Tangents of a circle in the plane z = 0, almost.
      const double angle = 6.283185307179586 * static_cast<double>(random.between(0, 1));
      plane[0] = std::cos(angle), plane[1] = std::sin(angle), plane[2] = 0, plane[3] = 1.02;
    }
    const auto corner = [&](double x, double y) { return std::array<double, 4>{x, y, static_cast<double>(random.between(-1.3f, 1.3f)), 1}; };
    const std::array<std::array<double, 4>, 3> triangle{corner(-2.1, -1.2), corner(2.1, -1.2), corner(0, 2.4)};
    const ClippedPolygon polygon = clip_triangle(triangle, 63 | 0xff00, limits);
    most = std::max(most, polygon.count);
    for (int c = 0; c < polygon.count; ++c)
      for (const auto& plane : limits.user_planes) {
        const double* p = polygon.corner[static_cast<std::size_t>(c)].position;
        CHECK(plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3] * p[3] >= -1e-12);
      }
  }
  CHECK(most >= 10);
  CHECK(most <= 17);
}

TEST_CASE("clipping: a plane of the world keeps what lies before it in the world", "[pipeline]") {
  const glm::mat4 clip_from_world = glm::mat4(2, 0, 0, 0, 0, 3, 0, 0, 0, 0, -1, -1, 0.5f, 0, -2, 4);
  const glm::dvec4 world_plane(0.3, -0.8, 0.1, 0.7), plane = clip_plane_from_world(world_plane, clip_from_world);
  test::Random random(87);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec4 world(random.between(-5, 5), random.between(-5, 5), random.between(-5, 5), 1);
    CHECK(glm::dot(plane, glm::dmat4(clip_from_world) * world) == Approx(glm::dot(world_plane, world)).margin(1e-12));
  }
}

}  // namespace tuberia
