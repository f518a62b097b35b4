#include "pipeline/validate_geometry.hpp"

#include <catch2/catch.hpp>

#include <functional>

#include "tests/support/meshes.hpp"

namespace tuberia {

using Catch::Matchers::Contains;

namespace {

/// A triangle with every array that a mesh can have, positions of all three kinds among them.
struct Arrays {
  std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, normals{3, {0, 0, 1}};
  std::vector<glm::vec4> clip_positions{3, {0, 0, 0, 1}}, quads{3, {1, 1, 1, 1}}, fewer{2};
  std::vector<ScreenVertex> screen_positions{{0, 0, 0, 1}, {6000, 0, 0.5f, 1}, {0, 6000, 1, 1}};
  std::vector<float> floats{1, 2};
  std::vector<std::uint8_t> bytes{1, 0, 1, 0};
};

/// The message of the refusal, which must leave the target as it was.
std::string refused(const MeshView& mesh, const PipelineState& state = {}, const FragmentProgram& program = gouraud()) {
  test::Studio studio({.width = 16, .height = 16, .background = {0.5f, 0, 0, 1}});
  const std::string before = studio.digest();
  const Result<DrawStatistics> drawn = studio.pipeline().draw(studio.target(), {.mesh = mesh, .program = program, .state = state});
  if (drawn) return "(accepted)";
  CHECK(studio.digest() == before);
  return drawn.error().message;
}

std::string refused_state(const std::function<void(PipelineState&)>& change) {
  const Arrays arrays;
  PipelineState state;
  change(state);
  return refused({.positions = arrays.positions}, state);
}

const float kNoNumber = std::numeric_limits<float>::quiet_NaN(), kBeyondAll = std::numeric_limits<float>::infinity();

}  // namespace

TEST_CASE("validate: a mesh has one kind of positions", "[pipeline]") {
  const Arrays a;
  CHECK(refused({.positions = a.positions}) == "(accepted)");
  CHECK(refused({.clip_positions = a.clip_positions}) == "(accepted)");
  CHECK(refused({.screen_positions = a.screen_positions}) == "(accepted)");
  CHECK_THAT(refused({.positions = a.positions, .clip_positions = a.clip_positions}), Contains("positions and clip_positions"));
  CHECK_THAT(refused({.clip_positions = a.clip_positions, .screen_positions = a.screen_positions}), Contains("clip_positions and screen_positions"));
}

TEST_CASE("validate: every array of a mesh is as long as its positions", "[pipeline]") {
  const Arrays a;
  CHECK(refused({.clip_positions = a.clip_positions, .back_colours = a.fewer}) == "the mesh has 3 positions but 2 back colours");
  CHECK(refused({.positions = a.positions, .fog_coordinates = a.floats}) == "the mesh has 3 positions but 2 fog coordinates");
  CHECK(refused({.screen_positions = a.screen_positions, .edge_flags = a.bytes}) == "the mesh has 3 positions but 4 edge flags");
  MeshView units{.positions = a.positions};
  units.unit_texcoords[2] = a.fewer;
  CHECK(refused(units) == "the mesh has 3 positions but 2 texture coordinates of unit 2");
  const std::vector<std::uint32_t> indices{0, 1, 3};
  CHECK(refused({.screen_positions = a.screen_positions, .indices = indices}) == "index 2 is 3, but the mesh has 3 vertices");
}

TEST_CASE("validate: vertices of the screen are named when they leave it", "[pipeline]") {
  const auto with = [](const ScreenVertex& vertex) {
    Arrays a;
    a.screen_positions[1] = vertex;
    return refused({.screen_positions = a.screen_positions});
  };
  constexpr int kEdge = 1 << 23;
  CHECK(with({kEdge, -kEdge, 1, 1e-30f}) == "(accepted)");
  CHECK_THAT(with({kEdge + 1, 0, 0, 1}), Contains("screen vertex 1 at (8388609, 0)"));
  CHECK_THAT(with({0, std::numeric_limits<std::int32_t>::min(), 0, 1}), Contains("screen vertex 1") && Contains("guard band"));
  for (const float depth : {-0.1f, 1.1f, kNoNumber, kBeyondAll}) CHECK_THAT(with({0, 0, depth, 1}), Contains("screen vertex 1") && Contains("depth"));
  for (const float w : {0.0f, -1.0f, kNoNumber, kBeyondAll}) CHECK_THAT(with({0, 0, 0, w}), Contains("screen vertex 1 has w"));
}

TEST_CASE("validate: what needs a place in the world does not run on the screen", "[pipeline]") {
  const Arrays a;
  const MeshView mesh{.screen_positions = a.screen_positions, .normals = a.normals};
  CHECK_THAT(refused(mesh, {}, phong({})), Contains("phong") && Contains("positions in the world"));
  PipelineState state;
  state.transform.vertex_lighting = Lighting{};
  CHECK_THAT(refused(mesh, state), Contains("vertex lighting needs positions in the world"));
  const MeshView in_clip{.clip_positions = a.clip_positions, .normals = a.normals};
  CHECK(refused(in_clip, state) == "(accepted)");
  state.transform.two_sided_colours = true;
  state.transform.back_lighting = Lighting{.light_count = 7};
  CHECK_THAT(refused(in_clip, state), Contains("back faces: its number of lights is 7"));
  state.transform.two_sided_colours = false;
  CHECK(refused(in_clip, state) == "(accepted)");
}

TEST_CASE("validate: matrices and planes are finite", "[pipeline]") {
  CHECK(refused_state([](PipelineState& s) { s.transform.world_from_object[2][1] = kNoNumber; }) == "world_from_object has nan in row 1, column 2");
  CHECK_THAT(refused_state([](PipelineState& s) { s.transform.clip_from_world[0][3] = -kBeyondAll; }), Contains("clip_from_world has -inf in row 3"));
  CHECK_THAT(refused_state([](PipelineState& s) { s.transform.view_from_world[0][0] = kBeyondAll; }), Contains("view_from_world"));
  for (const int count : {-1, 9}) {
    const auto message = refused_state([&](PipelineState& s) { s.clipping.user_plane_count = count; });
    CHECK_THAT(message, Contains("user_plane_count is " + std::to_string(count)));
  }
  const auto plane = [](int count) {
    return refused_state([&](PipelineState& s) {
      s.clipping.user_plane_count = count;
      s.clipping.user_planes[2].w = static_cast<double>(kNoNumber);
    });
  };
  CHECK(plane(3) == "user plane 2 has nan as its w; it must be finite");
  CHECK(plane(2) == "(accepted)");
}

TEST_CASE("validate: values that their enumerations do not have are refused by name", "[pipeline]") {
  const auto check = [](const char* words, auto&& change) {
    CHECK_THAT(refused_state(change), Contains(words));
  };
  check("topology is 7;", [](PipelineState& s) { s.assembly.topology = static_cast<Topology>(7); });
  check("volume is -1;", [](PipelineState& s) { s.clipping.volume = static_cast<ClipVolume>(-1); });
  check("front_face is 2;", [](PipelineState& s) { s.culling.front_face = static_cast<Winding>(2); });
  check("cull is 3;", [](PipelineState& s) { s.culling.cull = static_cast<CullFace>(3); });
  check("front_mode is 3;", [](PipelineState& s) { s.rasterization.front_mode = static_cast<PolygonMode>(3); });
  check("back_mode is 255;", [](PipelineState& s) { s.rasterization.back_mode = static_cast<PolygonMode>(255); });
  check("rasterization.perspective is 5;", [](PipelineState& s) { s.rasterization.perspective = static_cast<PerspectiveCorrection>(5); });
  check("rasterization.edge_arithmetic is 4;", [](PipelineState& s) { s.rasterization.edge_arithmetic = static_cast<EdgeArithmetic>(4); });
  check("fog.mode is 4;", [](PipelineState& s) { s.fog.mode = static_cast<FogMode>(4); });
  check("alpha_test.test is 8;", [](PipelineState& s) { s.alpha_test.test = static_cast<Compare>(8); });
  check("depth.test is 8;", [](PipelineState& s) { s.depth.test = static_cast<Compare>(8); });
  check("stencil's pass is 8;", [](PipelineState& s) { s.stencil.back.pass = static_cast<StencilOperation>(8); });
  check("blend.mode is 4;", [](PipelineState& s) { s.blend.mode = static_cast<BlendMode>(4); });
  check("blend's source is 15;", [](PipelineState& s) { s.blend.alpha.source = static_cast<BlendFactor>(15); });
  check("blend's equation is 5;", [](PipelineState& s) { s.blend.colour.equation = static_cast<BlendEquation>(5); });
  check("blend.logic is 17;", [](PipelineState& s) { s.blend.logic = static_cast<LogicOperation>(17); });
  check("source is 6;", [](PipelineState& s) { s.transform.texture_units[3].source[2] = static_cast<TexCoordSource>(6); });
}

TEST_CASE("validate: sizes, widths, patterns and offsets stay in their ranges", "[pipeline]") {
  const auto point = [](float size) { return refused_state([&](PipelineState& s) { s.rasterization.point.size_pixels = size; }); };
  const auto line = [](float width) { return refused_state([&](PipelineState& s) { s.rasterization.line.width_pixels = width; }); };
  for (const float good : {1.0f, 1.5f, 2048.0f}) CHECK((point(good) == "(accepted)" && line(good) == "(accepted)"));
  CHECK(point(1.0f / 256) == "(accepted)");
  for (const float bad : {0.0f, -1.0f, 2048.5f, kNoNumber, kBeyondAll}) {
    CHECK_THAT(point(bad), Contains("point size_pixels is"));
    CHECK_THAT(line(bad), Contains("line width_pixels is"));
  }
  CHECK_THAT(line(0.9f), Contains("line width_pixels is 0.9"));
  for (const int bits : {-1, 9})
    CHECK(refused_state([&](PipelineState& s) { s.rasterization.subpixel_bits = bits; }) ==
          "rasterization.subpixel_bits is " + std::to_string(bits) + ", outside 0 to 8");
  for (const int bits : {0, 8}) CHECK(refused_state([&](PipelineState& s) { s.rasterization.subpixel_bits = bits; }) == "(accepted)");
  for (const int factor : {0, 257, -3}) {
    const auto message = refused_state([&](PipelineState& s) { s.rasterization.line.stipple = StipplePattern{0xff, factor}; });
    CHECK_THAT(message, Contains("stipple factor is " + std::to_string(factor)));
  }
  CHECK_THAT(refused_state([](PipelineState& s) { s.rasterization.polygon_offset.factor = kNoNumber; }), Contains("offset's factor"));
  CHECK_THAT(refused_state([](PipelineState& s) { s.rasterization.polygon_offset.units = kBeyondAll; }), Contains("offset's units"));
  CHECK_THAT(refused_state([](PipelineState& s) { s.rasterization.polygon_offset.clamp = kNoNumber; }), Contains("offset's clamp"));
}

}  // namespace tuberia
