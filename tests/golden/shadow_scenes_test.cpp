// Pictures of shadows by depth map: biases, filters, kinds of light, thrown pictures.

#include <catch2/catch.hpp>

#include "tests/golden/golden_scene.hpp"
#include "tests/support/shadow_scenes.hpp"

namespace tuberia {

namespace {

using test::ShadowScene;
using test::Studio;

/// All parts of a scene in one part of the picture, in white plaster.
void draw_shadow_scene(Studio& studio, const ShadowScene& scene, std::vector<SurfaceLight> lights, const std::optional<Viewport>& cell = {}) {
  const SurfaceUniforms plaster{.reflection = {.model = Reflection::blinn_phong, .ambient = {0.1f, 0.12f, 0.16f}, .diffuse = {0.75f, 0.72f, 0.66f}, .specular = glm::vec3(0.1f), .exponent = 30},
                                .ambient_light = glm::vec3(1), .lights = std::move(lights), .eye = glm::vec3(scene.eye.eye), .two_sided = true};
  for (DrawCall& draw : scene.draws()) {
    draw.state.transform.clip_from_world = test::value_of(camera_matrices(scene.eye)).clip_from_world;
    draw.state.viewport.viewport = cell;
    studio.draw(draw.mesh, surface(plaster), draw.state);
  }
}

ShadowMap drawn_map(Studio& studio, const ShadowScene& scene, const Light& light, int size) {
  return test::value_of(draw_shadow_map(studio.pipeline(), scene.draws(), light, scene.bounds(), {.size = size}));
}

/// Seen from the same place through a window of another shape.
Camera with_aspect(Camera camera, double aspect) {
  camera.view.left = camera.view.bottom * aspect;
  camera.view.right = camera.view.top * aspect;
  return camera;
}

constexpr double kCellAspect = 51.0 / 118.0;

/// No bias, the defaults, and much too much of it.
void shadow_biases(Studio& studio) {
  ShadowScene scene = test::cards_and_a_ball();
  scene.eye = with_aspect(test::eye_at({-4.5, 8, 8.5}, {-0.3, 0.3, 0}), kCellAspect);
  for (int i = 0; i < 3; ++i) {
    ShadowMap map = drawn_map(studio, scene, test::kSunBehind, 128);
    if (i != 1) map.slope_bias = 0;
    if (i == 0) map.constant_bias = 0;
    if (i == 2) map.constant_bias = 0.5f;
    draw_shadow_scene(studio, scene, {{test::kSunBehind, map, {}}}, test::grid_cell(i, 0, 3, 1));
  }
}

/// One texel, 2 x 2 and 3 x 3 of a coarse map.
void shadow_taps(Studio& studio) {
  ShadowScene scene = test::cards_and_a_ball();
  scene.eye = with_aspect(test::eye_at({-4.5, 8, 8.5}, {-0.3, 0.3, 0}), kCellAspect);
  for (int i = 0; i < 3; ++i) {
    ShadowMap map = drawn_map(studio, scene, test::kSunBehind, 64);
    map.taps = i + 1;
    draw_shadow_scene(studio, scene, {{test::kSunBehind, map, {}}}, test::grid_cell(i, 0, 3, 1));
  }
}

/// The sun; a spot; a lamp that shines all around, among what it lights.
void shadow_lights(Studio& studio) {
  ShadowScene outside = test::spheres_on_a_plane(), inside = test::room();
  outside.eye = with_aspect(test::eye_at({4, 8, 10}, {0, 0.8, 0}), kCellAspect);
  inside.eye = with_aspect(test::eye_at({2.8, 2.7, 2.8}, {-0.5, 0.9, -0.8}), kCellAspect);
  const Light spot{.kind = Light::Kind::spot, .towards = {2, 6, 3}, .axis = glm::normalize(glm::vec3(-2, -5.5f, -3)), .cos_inner = 0.94f, .cos_outer = 0.9f};
  const Light lamp{.kind = Light::Kind::point, .towards = {0.1f, 1.7f, 0.2f}};
  const auto shadowed = [&](const ShadowScene& scene, const Light& light) {
    ShadowMap map = drawn_map(studio, scene, light, 512);
    map.taps = 2;
    return SurfaceLight{light, map, {}};
  };
  draw_shadow_scene(studio, outside, {shadowed(outside, test::kSun)}, test::grid_cell(0, 0, 3, 1));
  draw_shadow_scene(studio, outside, {shadowed(outside, spot)}, test::grid_cell(1, 0, 3, 1));
  draw_shadow_scene(studio, inside, {shadowed(inside, lamp)}, test::grid_cell(2, 0, 3, 1));
}

/// A slide projector, whose picture bends over what it meets and is missing behind it, and a weak sun.
void slide_projector(Studio& studio) {
  ShadowScene scene = test::spheres_on_a_plane();
  scene.eye = with_aspect(test::eye_at({2, 6, 7}, {-0.2, 0.4, 0.2}), 160.0 / 120.0);
  const Camera projector = test::eye_at({4, 7, 3}, {0, 0.3, 0});
  const LightView view = test::value_of(light_view(projector));
  ShadowMap map = test::value_of(draw_shadow_map(studio.pipeline(), scene.draws(), view, {.size = 512}));
  map.taps = 2;
  Image<Rgba8> slide = test::checkerboard(64, 8, {250, 200, 60, 255}, {40, 90, 200, 255});
  for (int y = 8; y < 24; ++y)
    for (int x = 8; x < 40; ++x) slide.at(x, y) = {200, 40, 40, 255};  // a mark that says which way is up
  const ProjectedTexture thrown{.texture = test::texture_of(slide, TextureEncoding::srgb), .map_from_world = view.map_from_world};
  const Light light{.kind = Light::Kind::point, .towards = glm::vec3(projector.eye), .intensity = glm::vec3(1.2f)};
  Light sun = test::kSun;
  sun.intensity = glm::vec3(0.15f);
  draw_shadow_scene(studio, scene, {{light, map, thrown}, {sun, {}, {}}});
}

/// A square light as 4 x 4 points, each with a map of its own.
void soft_shadow(Studio& studio) {
  ShadowScene scene = test::spheres_on_a_plane();
  scene.eye = with_aspect(test::eye_at({2, 6, 7}, {-0.2, 0.4, 0.2}), 160.0 / 120.0);
  std::vector<SurfaceLight> points;
  for (int i = 0; i < 16; ++i) {
    const auto offset = [](int k) { return 0.5f * static_cast<float>(k) - 0.75f; };
    const Light point{.kind = Light::Kind::point, .towards = {3 + offset(i % 4), 6, 2 + offset(i / 4)}, .intensity = glm::vec3(1.0f / 16)};
    ShadowMap map = drawn_map(studio, scene, point, 256);
    map.taps = 2;
    points.push_back({point, map, {}});
  }
  draw_shadow_scene(studio, scene, std::move(points));
}

}  // namespace

TEST_CASE("golden: shadow biases", "[golden][A20][A18]") { test::check_golden("shadow_biases", test::golden_canvas(), shadow_biases); }
TEST_CASE("golden: shadow taps", "[golden][A18]") { test::check_golden("shadow_taps", test::golden_canvas(), shadow_taps); }
TEST_CASE("golden: shadow lights", "[golden][A14][A18]") { test::check_golden("shadow_lights", test::golden_canvas(), shadow_lights); }
TEST_CASE("golden: slide projector", "[golden][A19]") { test::check_golden("slide_projector", test::golden_canvas(), slide_projector); }
TEST_CASE("golden: soft shadow", "[golden][A13]") { test::check_golden("soft_shadow", test::golden_canvas(), soft_shadow); }

}  // namespace tuberia
