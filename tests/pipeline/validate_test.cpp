#include "pipeline/validate.hpp"

#include <catch2/catch.hpp>

#include "tests/support/meshes.hpp"

namespace tuberia {

using Catch::Matchers::Contains;

namespace {

/// A square that any program can draw.
test::Mesh complete_mesh() {
  test::Mesh mesh = test::rectangle({-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  mesh.custom.assign(4, glm::vec4(0));
  return mesh;
}

/// The message of the refusal, which must leave the target as it was.
std::string refusal(const test::Mesh& mesh, const FragmentProgram& program, const PipelineState& state = {}) {
  test::Studio studio({.width = 16, .height = 16, .background = {0.5f, 0, 0, 1}});
  const std::string before = studio.digest();
  const Result<DrawStatistics> drawn = studio.pipeline().draw(studio.target(), {.mesh = mesh.view(), .program = program, .state = state});
  if (drawn) return "(accepted)";
  CHECK(studio.digest() == before);
  return drawn.error().message;
}

FragmentProgram any_texture() { return textured({.texture = test::texture_of(Image<Rgba8>(1, 1)), .sampler = {}}); }

}  // namespace

TEST_CASE("validate: a draw that lacks nothing is accepted", "[pipeline]") {
  test::Studio studio({});
  const test::Mesh mesh = complete_mesh();
  const DrawStatistics drawn = studio.draw(mesh.view(), gouraud());
  CHECK(drawn.triangles_in == 2);
  CHECK(drawn.triangles_drawn == 2);
  CHECK(drawn.triangles_clipped == 0);
  CHECK(drawn.vertices == 4);
  CHECK(test::pixels_drawn(studio.picture().colour) == 1024);
}

TEST_CASE("validate: an index out of range is named with its place", "[pipeline]") {
  test::Mesh mesh = complete_mesh();
  mesh.indices = {0, 1, 2, 0, 4, 3};
  CHECK(refusal(mesh, gouraud()) == "index 4 is 4, but the mesh has 4 vertices");
  mesh.indices[0] = 0xffffffff;
  CHECK(refusal(mesh, gouraud()) == "index 0 is 4294967295, but the mesh has 4 vertices");
  // Far behind others, where another worker looks.
  mesh.indices.assign(200001, 3);
  mesh.indices[199999] = 77;
  mesh.indices[200000] = 99;
  CHECK(refusal(mesh, gouraud()) == "index 199999 is 77, but the mesh has 4 vertices");
}

TEST_CASE("validate: attributes come one a vertex or not at all", "[pipeline]") {
  const auto with = [](auto member, std::size_t length) {
    test::Mesh mesh = complete_mesh();
    (mesh.*member).resize(length);
    return refusal(mesh, gouraud());
  };
  CHECK(with(&test::Mesh::normals, 3) == "the mesh has 4 positions but 3 normals");
  CHECK(with(&test::Mesh::texcoords, 5) == "the mesh has 4 positions but 5 texture coordinates");
  CHECK(with(&test::Mesh::colours, 1) == "the mesh has 4 positions but 1 colours");
  CHECK(with(&test::Mesh::custom, 9) == "the mesh has 4 positions but 9 custom attributes");
  CHECK(with(&test::Mesh::colours, 0) == "(accepted)");
}

TEST_CASE("validate: a program gets what it reads or does not run", "[pipeline]") {
  test::Mesh mesh = complete_mesh();
  mesh.normals.clear();
  mesh.texcoords.clear();
  CHECK_THAT(refusal(mesh, phong({})), Contains("phong") && Contains("normals"));
  CHECK_THAT(refusal(mesh, any_texture()), Contains("textured") && Contains("texture coordinates"));
  CHECK(refusal(mesh, FragmentProgram()) == "the draw has no fragment program");
}

TEST_CASE("validate: lighting needs normals and a sensible number of lights", "[pipeline]") {
  PipelineState state;
  state.transform.vertex_lighting = Lighting{};
  CHECK(refusal(complete_mesh(), gouraud(), state) == "(accepted)");
  for (const int count : {-1, 5, 1000}) {
    state.transform.vertex_lighting->light_count = count;
    CHECK_THAT(refusal(complete_mesh(), gouraud(), state), Contains("number of lights is " + std::to_string(count)));
  }
  state.transform.vertex_lighting->light_count = 1;
  test::Mesh mesh = complete_mesh();
  mesh.normals.clear();
  CHECK_THAT(refusal(mesh, gouraud(), state), Contains("needs normals"));
}

TEST_CASE("validate: lighting that is not finite is named, field and value", "[pipeline]") {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
  const auto both = [](const Lighting& lighting) {
    PipelineState state;
    state.transform.vertex_lighting = lighting;
    const std::string vertices = refusal(complete_mesh(), gouraud(), state), fragments = refusal(complete_mesh(), phong(lighting));
    return vertices == "(accepted)" ? fragments : vertices + "\n" + fragments;
  };
  const auto refused_twice = [&](const Lighting& lighting, const std::string& words) {
    CHECK_THAT(both(lighting), Contains("vertex lighting: " + words) && Contains("program 'phong': " + words));
  };
  CHECK(both({}) == "(accepted)");
  refused_twice({.ambient = glm::vec3(0, kNaN, 0)}, "ambient.y is nan");
  refused_twice({.diffuse = glm::vec3(kInfinity)}, "diffuse.x is inf");
  refused_twice({.specular = glm::vec3(0, 0, kNaN)}, "specular.z is nan");
  refused_twice({.shininess = -1}, "shininess is -1");
  refused_twice({.shininess = kNaN}, "shininess is nan");
  refused_twice({.alpha = kNaN}, "alpha is nan");
  refused_twice({.eye = glm::vec3(kInfinity, 0, 0)}, "eye.x is inf");
  Lighting lit;
  lit.lights[0].towards.y = kNaN;
  refused_twice(lit, "lights[0].towards.y is nan");
  lit.lights[0] = {.intensity = glm::vec3(0, 0, kInfinity)};
  refused_twice(lit, "lights[0].intensity.z is inf");
  lit.light_count = 0;  // nobody reads it
  CHECK(both(lit) == "(accepted)");
}

TEST_CASE("validate: a program with uniforms it cannot draw with is refused", "[pipeline]") {
  for (const int count : {-1, 5}) {
    CHECK_THAT(refusal(complete_mesh(), phong({.light_count = count})), Contains("phong") && Contains("number of lights"));
    TexturedLitUniforms uniforms{.texture = test::texture_of(Image<Rgba8>(1, 1)), .sampler = {}, .lighting = {.light_count = count}};
    CHECK_THAT(refusal(complete_mesh(), textured_lit(uniforms)), Contains("textured_lit") && Contains("number of lights"));
  }
  CHECK_THAT(refusal(complete_mesh(), textured({})), Contains("textured") && Contains("no texture"));
  CHECK_THAT(refusal(complete_mesh(), textured_lit({})), Contains("no texture"));
  CHECK_THAT(refusal(complete_mesh(), textured_gouraud({})), Contains("no texture"));
}

TEST_CASE("validate: a viewport out of range is named", "[pipeline]") {
  constexpr int kMost = RenderTarget::kMaxSize, kLeast = std::numeric_limits<int>::min();
  const auto with = [](Viewport viewport) {
    PipelineState state;
    state.viewport.viewport = viewport;
    return refusal(complete_mesh(), gouraud(), state);
  };
  CHECK_THAT(with({0, 0, -1, 10}), Contains("-1x10") && Contains("out of range"));
  CHECK_THAT(with({0, 0, kMost + 1, 10}), Contains("16385x10"));
  CHECK_THAT(with({-kMost - 1, 0, 10, 10}), Contains("(-16385, 0)"));
  CHECK_THAT(with({0, kMost + 1, 10, 10}), Contains("(0, 16385)"));
  CHECK_THAT(with({kLeast, 0, 10, 10}), Contains("out of range"));
  CHECK(with({-kMost, -kMost, kMost, kMost}) == "(accepted)");
  CHECK(with({kMost, kMost, kMost, kMost}) == "(accepted)");
}

TEST_CASE("validate: a depth range must lie in [0, 1]", "[pipeline]") {
  const auto with = [](DepthRange range) {
    PipelineState state;
    state.viewport.depth_range = range;
    return refusal(complete_mesh(), gouraud(), state);
  };
  CHECK_THAT(with({-0.5f, 1}), Contains("depth range -0.5"));
  CHECK_THAT(with({0, 1.5f}), Contains("1.5"));
  CHECK_THAT(with({0, std::numeric_limits<float>::quiet_NaN()}), Contains("depth range"));
  CHECK(with({1, 1}) == "(accepted)");
}

TEST_CASE("validate: targets have a size between 1 and 16384", "[raster]") {
  for (const auto& [width, height] : {std::pair{0, 5}, {5, 0}, {-3, 5}, {16385, 1}, {1, 16385}}) {
    const auto target = RenderTarget::create(width, height);
    REQUIRE(!target.ok());
    CHECK_THAT(target.error().message, Contains(std::to_string(width) + "x" + std::to_string(height)));
  }
}

TEST_CASE("validate: nothing to draw is no error", "[pipeline]") {
  CHECK(refusal(test::Mesh{}, gouraud()) == "(accepted)");
  test::Mesh points;
  points.positions.assign(2, glm::vec3(0));
  CHECK(refusal(points, gouraud()) == "(accepted)");
}

}  // namespace tuberia
