// Meshes that come in clip space, or snapped to the screen.

#include <catch2/catch.hpp>

#include "tests/support/meshes.hpp"

namespace tuberia {

namespace {

/// What the geometry stages made of a mesh's vertices, by their numbers in the mesh.
struct VertexCatcher : Observer {
  std::vector<glm::vec4> clip;
  std::vector<ScreenVertex> screen;
  std::vector<float> fog;
  void after(Stage stage, const Chunk& chunk) override {
    const VertexBatch& v = chunk.vertices;
    for (std::size_t i = 0; i < v.source.size(); ++i) {
      if (stage == Stage::vertex_transform) place(clip, v.source[i], {v.clip_x[i], v.clip_y[i], v.clip_z[i], v.clip_w[i]});
      if (stage == Stage::perspective_divide) place(screen, v.source[i], {v.screen[i].x, v.screen[i].y, v.screen[i].depth, v.clip_w[i]});
      if (stage == Stage::set_up && !v.fog_coordinates.empty()) place(fog, v.source[i], v.fog_coordinates[i]);
    }
  }
  template <class T>
  static void place(std::vector<T>& list, std::size_t at, const T& value) {
    if (list.size() <= at) list.resize(at + 1);
    list[at] = value;
  }
};

}  // namespace

TEST_CASE("positions: of clip space or the screen give the picture of the object's", "[pipeline][exact]") {
  const test::Mesh ball = test::sphere(20);
  PipelineState state;
  state.transform.clip_from_world = test::clip_from_world({1.5, 1.25, 2.5}, 1.25);
  VertexCatcher caught;
  test::Studio whole({.width = 100, .height = 80});
  REQUIRE(whole.pipeline().draw(whole.target(), {.mesh = ball.view(), .program = gouraud(), .state = state}, caught).ok());

  MeshView given = ball.view();
  given.positions = {};
  state.transform.clip_from_world = glm::mat4(0.0f);  // of no use to anyone
  for (const bool on_screen : {false, true})
    for (const int threads : {1, 2, 7}) {
      test::Studio studio({.width = 100, .height = 80, .options = {.threads = threads}});
      given.clip_positions = {};
      given.screen_positions = {};
      if (on_screen) given.screen_positions = caught.screen;
      else given.clip_positions = caught.clip;
      const DrawStatistics drawn = studio.draw(given, gouraud(), state);
      CHECK(studio.digest() == whole.digest());
      CHECK(drawn.triangles_drawn > 100);
    }
}

TEST_CASE("positions: programs see those of clip space as they are", "[pipeline]") {
  // Lit by a point light, which asks where the vertex is.
  const std::vector<glm::vec4> corners{{-1, -1, 0, 1}, {1, -1, 0, 1}, {-1, 1, 0, 1}, {1, 1, 0, 1}};
  const std::vector<glm::vec3> normals(4, {0, 0, 1});
  PipelineState state;
  state.assembly.topology = Topology::triangle_strip;
  state.transform.world_from_object = glm::mat4(5.0f);
  Lighting lighting{.ambient = glm::vec3(0), .diffuse = glm::vec3(1)};
  lighting.lights[0] = {.kind = Light::Kind::point, .towards = {-1, -1, 1}, .intensity = glm::vec3(1)};
  test::Studio studio({});
  studio.draw({.clip_positions = corners, .normals = normals}, phong(lighting), state);
  const Image<Rgba8> image = studio.picture().colour;
  CHECK(image.at(0, 63).r == 255);
  CHECK(image.at(63, 0).r == Approx(255 / 3.0).margin(2));
}

TEST_CASE("fog: coordinates are the mesh's or w, one for each slot", "[pipeline]") {
  const std::vector<glm::vec4> line{{0, 0, 0, 1}, {0, 0, -6, 2}, {0.5f, 0, 0, 3}};
  const std::vector<float> given{10, 20, -5};
  PipelineState state;
  state.assembly.topology = Topology::line_strip;
  state.fog.mode = FogMode::exp;
  state.transform.two_sided_colours = true;
  const auto coordinates = [&](const MeshView& mesh) {
    struct All : Observer {
      AlignedVector<float> fog;
      void after(Stage stage, const Chunk& chunk) override {
        if (stage == Stage::set_up) fog = chunk.vertices.fog_coordinates;
      }
    } all;
    test::Studio studio({});
    REQUIRE(studio.pipeline().draw(studio.target(), {.mesh = mesh, .program = gouraud(), .state = state}, all).ok());
    return std::vector<float>(all.fog.begin(), all.fog.end());
  };
  // The first line leaves the near plane at a fifth of its way: w = 1.2.
  const std::vector<float> w = coordinates({.clip_positions = line});
  REQUIRE(w.size() == 10);
  CHECK((w[0] == 1 && w[1] == 2 && w[2] == 3));
  CHECK(w[3] == Approx(1.2));
  const std::vector<float> own = coordinates({.clip_positions = line, .fog_coordinates = given});
  REQUIRE(own.size() == 10);
  CHECK((own[0] == 10 && own[1] == 20 && own[2] == -5));
  CHECK(own[3] == Approx(12));
  for (std::size_t i = 0; i < 5; ++i) CHECK(own[i] == own[i + 5]);
  state.fog.mode = FogMode::off;
  CHECK(coordinates({.clip_positions = line}).empty());
}

}  // namespace tuberia
