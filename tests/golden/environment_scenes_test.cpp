// Pictures of what mirrors its surroundings, and of the surroundings themselves.

#include <catch2/catch.hpp>

#include <cmath>
#include <optional>

#include "pipeline/programs/surface.hpp"
#include "scene/environment/background.hpp"
#include "scene/environment/environment_maps.hpp"
#include "scene/environment/render_cube.hpp"
#include "scene/environment/sky.hpp"
#include "scene/shapes/shapes.hpp"
#include "tests/golden/golden_scene.hpp"
#include "tests/support/mesh_view.hpp"

namespace tuberia {

namespace {

using test::Studio;

/// Texels as multiples of 1/1024, so that no library's last bit can show.
Image<Rgba32F> rounded(Image<Rgba32F> image) {
  const auto to_lattice = [](float a) { return std::round(a * 1024) / 1024; };
  for (Rgba32F& texel : image.pixels()) texel = {to_lattice(texel.r), to_lattice(texel.g), to_lattice(texel.b), 1};
  return image;
}
CubeImages rounded(CubeImages faces) {
  for (Image<Rgba32F>& face : faces) face = rounded(std::move(face));
  return faces;
}

Image<Rgba32F> sky_panorama(const Sky& sky = {}) { return rounded(panorama_of(sky_surroundings(sky), 256, 128)); }

Camera camera_at(const glm::dvec3& eye, const glm::dvec3& towards, double aspect = 160.0 / 120) {
  Camera camera{.eye = eye, .point_of_interest = towards};
  camera.view = *perspective_volume(0.75, aspect, 0.1, 100);
  return camera;
}

/// Draws as seen by one camera, into one viewport.
struct View {
  Pipeline& pipeline;
  RenderTarget& target;
  Camera camera;
  std::optional<Viewport> viewport{};

  void draw(DrawCall call) const {
    call.state.viewport.viewport = viewport;
    REQUIRE(pipeline.draw(target, call));
  }
  void background(const EnvironmentMap& map) const {
    const auto behind = Background::create(camera);
    REQUIRE(behind);
    draw(behind->draw(map));
  }
  void shape(const Mesh& mesh, SurfaceUniforms uniforms, const glm::mat4& world_from_object = glm::mat4(1)) const {
    uniforms.eye = camera.eye;
    DrawCall call{.mesh = test::view_of(mesh), .program = surface(std::move(uniforms)), .state = {}};
    call.state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
    call.state.transform.world_from_object = world_from_object;
    draw(std::move(call));
  }
};

SurfaceUniforms mirror_of(const EnvironmentMap& map, const glm::vec3& kps) {
  SurfaceUniforms uniforms;
  uniforms.reflection.ambient = uniforms.reflection.diffuse = glm::vec3(0);
  uniforms.environment = map;
  uniforms.mirror = kps;
  return uniforms;
}

SurfaceUniforms painted(const glm::vec3& colour, const glm::vec3& towards_light) {
  SurfaceUniforms uniforms;
  uniforms.reflection.ambient = uniforms.reflection.diffuse = colour;
  uniforms.ambient_light = glm::vec3(0.25f);
  uniforms.lights = {{.light = {.towards = towards_light}, .shadow = {}, .projected = {}}};
  return uniforms;
}

/// Above: a mirror ball before the sky, by cube, sphere map and panorama. Below: panorama and sphere map.
void environment_maps(Studio& studio) {
  const Surroundings sky = panorama_surroundings(sky_panorama());
  const EnvironmentMap maps[3] = {*cube_map(rounded(cube_of(sky, 64))), *sphere_map(rounded(sphere_map_of(sky, 128))), *panorama_map(sky_panorama())};
  const Mesh ball = *sphere_mesh({.slices = 64, .stacks = 32});
  for (int i = 0; i < 3; ++i) {
    const View view{studio.pipeline(), studio.target(), camera_at({0, 0.4, 3.4}, {0, 0, 0}, 52.0 / 58), test::grid_cell(i, 0, 3, 2)};
    view.background(maps[i]);
    view.shape(ball, mirror_of(maps[i], glm::vec3(0.9f, 0.92f, 0.95f)));
  }
  const Mesh picture = *plane_mesh({.width = 2, .depth = 2});
  const Viewport places[2] = {{.x = 1, .y = 61, .width_pixels = 104, .height_pixels = 58}, {.x = 107, .y = 63, .width_pixels = 52, .height_pixels = 52}};
  for (std::size_t i = 0; i < 2; ++i) {
    DrawCall call{.mesh = test::view_of(picture), .program = textured({.texture = maps[2 - i].texture, .sampler = {}}), .state = {}};
    call.state.transform.clip_from_world = {{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}};  // the ground seen from above
    call.state.viewport.viewport = places[i];
    REQUIRE(studio.pipeline().draw(studio.target(), call));
  }
}

/// A corner of a coarse cube map, seen from its middle: the nearest texels with the faces' edges between them, and
/// filtered across those edges.
void environment_seams(Studio& studio) {
  EnvironmentMap map = *cube_map(rounded(cube_of(panorama_surroundings(sky_panorama()), 12)));
  map.sampler.mipmaps = MipmapFilter::none;
  for (int i = 0; i < 2; ++i) {
    map.sampler.texels = i == 0 ? TexelFilter::nearest : TexelFilter::bilinear;
    View{studio.pipeline(), studio.target(), camera_at({0, 0, 0}, {0.9, 0.75, -1}, 78.0 / 118), test::grid_cell(i, 0, 2, 1)}.background(map);
  }
}

/// The teapot as a mirror, by one picture for all directions.
void teapot_with_sphere_map(Studio& studio) {
  const EnvironmentMap map = *sphere_map(rounded(sphere_map_of(panorama_surroundings(sky_panorama()), 256)));
  const View view{studio.pipeline(), studio.target(), camera_at({1.2, 3.0, 7.4}, {0.2, 1.5, 0})};
  view.shape(*teapot_mesh({.segments = 6}), mirror_of(map, {0.95f, 0.85f, 0.6f}));
}

/// A room with coloured walls, two balls and a box, seen by its own mirror ball: six faces drawn first.
void room_in_a_ball(Studio& studio) {
  const Mesh box = *box_mesh({.width = 1, .height = 1.6, .depth = 1}), ball = *sphere_mesh({.slices = 48, .stacks = 24}), wall = *plane_mesh({.width = 8, .depth = 8});
  const glm::vec3 light(-0.48f, 0.64f, 0.6f);
  // Floor, ceiling, left, right, back and front: each the floor, turned to face the room's middle.
  struct Wall {
    glm::vec3 colour;
    glm::dvec3 axis;
    double angle;
  };
  constexpr double kQuarter = 1.5707963267948966;
  const Wall walls[6] = {{{0.5f, 0.45f, 0.4f}, {1, 0, 0}, 0},           {{0.85f, 0.85f, 0.8f}, {1, 0, 0}, 2 * kQuarter}, {{0.75f, 0.15f, 0.1f}, {0, 0, 1}, -kQuarter},
                         {{0.15f, 0.55f, 0.2f}, {0, 0, 1}, kQuarter},  {{0.2f, 0.35f, 0.8f}, {1, 0, 0}, kQuarter},      {{0.8f, 0.7f, 0.2f}, {1, 0, 0}, -kQuarter}};
  const auto furnish = [&](const View& view) {
    for (const Wall& each : walls) {
      SurfaceUniforms paint = painted(each.colour, light);
      paint.ambient_light = glm::vec3(0.7f);
      view.shape(wall, paint, compose(rotation(each.axis, each.angle), translation({0, -4, 0})));
    }
    view.shape(box, painted({0.9f, 0.6f, 0.2f}, light), translation({2.2, -3.2, -1.5}));
    view.shape(ball, painted({0.3f, 0.7f, 0.8f}, light), translation({-2.4, -2.6, 0.4}));
  };
  const DrawScene scene = [&](Pipeline& pipeline, RenderTarget& target, const Camera& camera) -> Result<Nothing> {
    furnish({pipeline, target, camera});
    return Nothing{};
  };
  const auto faces = render_cube(studio.pipeline(), {.eye = {0, -1.4, 0}, .size_pixels = 64}, scene);
  REQUIRE(faces);
  const View view{studio.pipeline(), studio.target(), camera_at({0, -0.6, 3.9}, {0, -1.5, 0})};
  furnish(view);
  view.shape(ball, mirror_of(*cube_map(*faces), glm::vec3(0.95f)), translation({0, -1.4, 0}));
}

/// Chrome and gold under the sky that they mirror, as films have used it.
void chrome_under_the_sky(Studio& studio) {
  const EnvironmentMap map = *panorama_map(sky_panorama());
  const View view{studio.pipeline(), studio.target(), camera_at({0.4, 0.2, 5.2}, {0, 0.45, 0})};
  view.background(map);
  view.shape(*torus_mesh({.radius = 1.15, .tube_radius = 0.32}), mirror_of(map, {0.95f, 0.75f, 0.35f}), compose(rotation({1, 0, 0.3}, 1.1), translation({0, 0, 0})));
  view.shape(*sphere_mesh({.radius = 0.62}), mirror_of(map, glm::vec3(0.92f)));
  view.shape(*sphere_mesh({.radius = 0.3}), mirror_of(map, glm::vec3(0.92f)), translation({1.5, 0.85, 0.6}));
  view.shape(*sphere_mesh({.radius = 0.22}), mirror_of(map, {0.9f, 0.5f, 0.4f}), translation({-1.6, 0.95, 0.2}));
}

/// The teapot with texture, relief and mirror, in the surroundings that it mirrors.
void teapot_in_its_environment(Studio& studio) {
  const EnvironmentMap map = *panorama_map(sky_panorama());
  const View view{studio.pipeline(), studio.target(), camera_at({-2.4, 2.6, -7.4}, {0.2, 1.55, 0})};
  view.background(map);
  SurfaceUniforms glazed = painted(glm::vec3(1), glm::vec3(glm::normalize(Sky{}.towards_sun)));
  glazed.colour.pattern = {.kind = Pattern::Kind::checker, .first = {0.5f, 0.07f, 0.05f}, .second = {0.75f, 0.68f, 0.5f}, .scale = 6};
  glazed.bump = {.kind = BumpMap::Kind::waves, .texture = nullptr, .sampler = {}, .gain = 0.1f, .scale = 6};
  glazed.environment = map;
  glazed.mirror = glm::vec3(0.3f);
  view.shape(*teapot_mesh({.segments = 6}), glazed);
}

}  // namespace

TEST_CASE("golden: mirrors of the sky by each kind of map", "[golden][exact][A28][A29][A32][A33][A34]") {
  test::check_golden("environment_maps", test::golden_canvas(), environment_maps);
}

TEST_CASE("golden: the corner of a cube map, with seams and without", "[golden][exact][A29][B37]") {
  test::check_golden("environment_seams", test::golden_canvas(), environment_seams);
}

TEST_CASE("golden: the teapot by a sphere map", "[golden][exact][A32][A35]") {
  test::check_golden("environment_teapot", test::golden_canvas(), teapot_with_sphere_map);
}

TEST_CASE("golden: a room in a mirror ball, by six faces drawn from its middle", "[golden][exact][A30][C38][B37]") {
  test::check_golden("environment_room", test::golden_canvas(), room_in_a_ball);
}

TEST_CASE("golden: chrome and gold under the sky", "[golden][exact][A37]") {
  test::check_golden("environment_chrome", test::golden_canvas(), chrome_under_the_sky);
}

TEST_CASE("golden: texture with relief and environment at once before what is mirrored", "[golden][exact][A36]") {
  test::check_golden("environment_combined", test::golden_canvas(), teapot_in_its_environment);
}

}  // namespace tuberia
