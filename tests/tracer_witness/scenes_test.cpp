// The pipeline and the ray tracer about scenes of the gallery: the same objects, and no difference without a reason.

#include <catch2/catch.hpp>

#include "examples/tuberia/witness/witness.hpp"
#include "scene/description/read_scene.hpp"

namespace tuberia::witness {
namespace {

constexpr glm::ivec2 kSmall{240, 160}, kTiny{120, 80};

SceneDescription witnessed_scene(const std::string& name) {
  const auto scene = read_scene("examples/scenes/" + name + ".json");
  if (!scene) FAIL(scene.error().message);
  return *scene;
}

Comparison compared(const SceneDescription& drawn, const SceneDescription& traced, const glm::ivec2& size_pixels = kSmall) {
  auto comparison = compare_witnesses(drawn, traced, {.size_pixels = size_pixels});
  if (!comparison) FAIL(comparison.error().message);
  return *std::move(comparison);
}

}  // namespace

TEST_CASE("tracer witness: scenes are confirmed", "[A40][A41][A44][C06][C41][Y5][tracer_witness]") {
  for (const char* name : {"04_phong", "06b_falloff_linear", "07_spot_light", "08c_overflow_hue_preserving", "09_cook_torrance", "10_shading", "12_lost_highlight", "21_parametric_mapping",
                           "22b_tunnel_trilinear", "23_solid_patterns", "30b_torus_bump", "33_bricks", "40_mirror_sphere", "41c_teapot_panorama_map", "43_rendered_surroundings", "44_film",
                           "50_shadows", "51_directional_shadows", "54_slide_projector", "60_one_of_each"}) {
    const SceneDescription scene = witnessed_scene(name);
    const Comparison comparison = compared(scene, scene);
    INFO(name << "\n" << summary_of(comparison));
    const Counts counts = counts_of(comparison);
    CHECK(counts.of(PixelClass::unexplained) == 0);
    CHECK(counts.same_objects() > kLeastSameObjects);
  }
}

// What is not opaque, before a mirror's surroundings, a texture and a shadow.

TEST_CASE("tracer witness: what shows through", "[A40][Y5][tracer_witness]") {
  const auto scene = scene_from_json(R"({"camera": {"eye": [0, 2, 6], "look_at": [0, 0.5, 0]}, "ambient": 0.2,
      "lights": [{"type": "directional", "towards": [1, 2, 1], "shadow": {"resolution": 256}}], "environment": {"source": "sky", "resolution": 64},
      "textures": {"tiles": {"source": "checker"}},
      "materials": {"floor": {"texture": "tiles", "diffuse": 1}, "chrome": {"diffuse": 0.1, "mirror": 0.8}, "pane": {"diffuse": [0.2, 0.5, 0.4], "alpha": 0.4}},
      "objects": [{"shape": {"type": "plane", "width": 8, "depth": 8}, "material": "floor"}, {"shape": {"type": "sphere"}, "material": "chrome", "transforms": [{"translate": [-1, 1, 0]}]},
                  {"shape": {"type": "plane", "width": 3, "depth": 2}, "material": "pane", "transforms": [{"rotate": 90, "about": [1, 0, 0]}, {"translate": [0, 1, 2]}]}]})", "pane.json");
  REQUIRE(scene);
  const Comparison comparison = compared(*scene, *scene);
  INFO(summary_of(comparison));
  CHECK(counts_of(comparison).of(PixelClass::unexplained) == 0);
  CHECK(counts_of(comparison).differing() > 1000);
}

// A witness that cannot refute proves nothing: the tracer is told a slightly different story.

namespace {

/// How many pixels cannot be explained if the tracer sees the scene otherwise.
template <class Change>
std::int64_t riddles(const std::string& name, const Change& change, const glm::ivec2& size_pixels = kTiny) {
  const SceneDescription scene = witnessed_scene(name);
  SceneDescription other = scene;
  change(other);
  return counts_of(compared(scene, other, size_pixels)).of(PixelClass::unexplained);
}

}  // namespace

TEST_CASE("tracer witness: a light that was moved is noticed", "[Y5][tracer_witness]") {
  CHECK(riddles("04_phong", [](SceneDescription& scene) { scene.lights[0].towards.x += 0.05; }) > 100);
  CHECK(riddles("50_shadows", [](SceneDescription& scene) { scene.lights[0].position.x += 0.05; }) > 20);
}

TEST_CASE("tracer witness: another texture is noticed", "[Y5][tracer_witness]") {
  CHECK(riddles("21_parametric_mapping", [](SceneDescription& scene) { std::swap(scene.textures[0].first, scene.textures[0].second); }) > 100);
}

TEST_CASE("tracer witness: a camera that was shifted by half a pixel is noticed", "[Y5][A41][tracer_witness]") {
  const SceneDescription scene = witnessed_scene("04_phong");
  SceneDescription other = scene;
  const double half_a_pixel = 0.5 * scene.camera.height / kSmall.y;
  other.camera.eye.x += half_a_pixel;
  other.camera.look_at.x += half_a_pixel;
  const Counts counts = counts_of(compared(scene, other));
  CHECK(counts.same_objects() < kLeastSameObjects);
  CHECK(counts.of(PixelClass::unexplained) > 100);
}

TEST_CASE("tracer witness: an object that is one percent larger is noticed", "[Y5][tracer_witness]") {
  CHECK(riddles("04_phong", [](SceneDescription& scene) { std::get<description::Sphere>(scene.objects[0].shape).radius *= 1.01; }) > 5);
}

TEST_CASE("tracer witness: what a technique does not do is not explained by it", "[Y5][tracer_witness]") {
  // Other maps, other vertices, other levels of detail: each would explain its own differences, not those.
  CHECK(riddles("50_shadows", [](SceneDescription& scene) { scene.lights[0].shadow->resolution /= 8; }) > 20);
  CHECK(riddles("52a_bias_acne", [](SceneDescription& scene) { scene.lights[0].shadow->slope_bias = 1; }) > 100);
  CHECK(riddles("12_lost_highlight", [](SceneDescription& scene) { std::get<description::Plane>(scene.objects[0].shape).segments = {3, 3}; }) > 100);
  CHECK(riddles("22b_tunnel_trilinear", [](SceneDescription& scene) { scene.textures[0].filter = description::Texture::Filter::mipmap_nearest; }) > 100);
  CHECK(riddles("40_mirror_sphere", [](SceneDescription& scene) { scene.environment->resolution /= 4; }) > 100);
}

// Two squares closer together than a depth buffer can tell; the farther one is drawn first.

TEST_CASE("tracer witness: depths that the buffer cannot tell apart", "[Y5][tracer_witness]") {
  const auto squares = [](double gap) {
    auto scene = scene_from_json(R"({"camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0]}, "ambient": 1,
      "materials": {"red": {"diffuse": [0.7, 0.1, 0.1]}, "blue": {"diffuse": [0.1, 0.1, 0.7]}},
      "objects": [{"shape": {"type": "plane"}, "material": "red", "transforms": [{"rotate": 90, "about": [1, 0, 0]}]},
                  {"shape": {"type": "plane"}, "material": "blue", "transforms": [{"rotate": 90, "about": [1, 0, 0]}]}]})", "squares.json");
    REQUIRE(scene);
    scene->objects[1].transforms.push_back({.kind = description::Transform::Kind::translate, .vector = {0, 0, gap}});
    return *scene;
  };
  const auto near_twins = squares(1e-7);
  const Counts counts = counts_of(compared(near_twins, near_twins, kTiny));
  CHECK(counts.of(PixelClass::depth) > 500);
  CHECK(counts.of(PixelClass::unexplained) == 0);
  // A gap of a thousandth is told apart: what was drawn is wrong then.
  CHECK(counts_of(compared(near_twins, squares(1e-3), kTiny)).of(PixelClass::unexplained) > 500);
}

}  // namespace tuberia::witness
