// Small scenes of one technique each: what it explains, and what it must not hide.

#include <catch2/catch.hpp>

#include "examples/tuberia/witness/explaining.hpp"
#include "examples/tuberia/witness/witness.hpp"
#include "scene/content/scene_camera.hpp"
#include "scene/description/read_scene.hpp"

namespace tuberia::witness {
namespace {

constexpr glm::ivec2 kTechniquePixels{96, 64};

SceneDescription technique_scene(const std::string& text) {
  const auto scene = scene_from_json(text, "technique.json");
  if (!scene) FAIL(scene.error().message);
  return *scene;
}

Comparison by_both(const SceneDescription& drawn, const SceneDescription& traced) {
  auto comparison = compare_witnesses(drawn, traced, {.size_pixels = kTechniquePixels});
  if (!comparison) FAIL(comparison.error().message);
  return *std::move(comparison);
}

std::int64_t unexplained(const SceneDescription& drawn, const SceneDescription& traced) { return counts_of(by_both(drawn, traced)).of(PixelClass::unexplained); }

/// Pixels that a cause is part of.
std::int64_t pixels_by(const Counts& counts, Cause cause) {
  std::int64_t pixels = 0;
  for (const auto& [bits, count] : counts.of_causes)
    if (Causes(bits).has(cause)) pixels += count;
  return pixels;
}

/// A clear ball and a chrome one over a floor; the light has a shadow map.
SceneDescription clear_and_chrome(const std::string& refractive_index) {
  return technique_scene(R"({"ambient": 0.3, "image": {"background": [0.2, 0.3, 0.5]}, "camera": {"eye": [0, 2, 6], "look_at": [0, 0.7, 0]},
    "lights": [{"type": "directional", "towards": [1, 2, 1]}], "environment": {"source": "sky", "resolution": 64},
    "materials": {"floor": {"diffuse": [0.8, 0.6, 0.4]}, "chrome": {"diffuse": 0.1, "mirror": 0.7},
      "glass": {"diffuse": 0.1, "specular": 0.4, "transmission": [0.8, 0.9, 0.7], "refractive_index": )" + refractive_index + R"(}},
    "objects": [{"shape": {"type": "plane", "width": 9, "depth": 9}, "material": "floor"},
      {"shape": {"type": "sphere"}, "material": "glass", "transforms": [{"translate": [-1.2, 1, 0]}]},
      {"shape": {"type": "sphere"}, "material": "chrome", "transforms": [{"translate": [1.2, 1, 0]}]}]})");
}

template <class Change>
SceneDescription changed(SceneDescription scene, const std::string& material, const Change& change) {
  for (description::Material& described : scene.materials)
    if (described.name == material) change(described);
  return scene;
}

}  // namespace

TEST_CASE("tracer witness: a pattern and relief on one object", "[Y5][tracer_witness]") {
  for (const char* pattern : {"wood", "marble"}) {
    const SceneDescription scene = technique_scene(std::string(R"({"camera": {"type": "orthographic", "eye": [2, 3, 4]}, "lights": [{"type": "point", "intensity": 0.6, "position": [4, 2.6, 4.3]}],
      "materials": {"m": {"model": "blinn-phong", "diffuse": [0.4, 0.3, 0.7], "specular": 0.4, "bump": {"type": "waves", "gain": 0.02}, "pattern": {"type": ")") + pattern + R"("}}},
      "objects": [{"shape": {"type": "teapot"}, "material": "m", "transforms": [{"scale": [0.6, 1, 1.7]}]}]})");
    const Comparison comparison = by_both(scene, scene);
    INFO(pattern << "\n" << summary_of(comparison));
    CHECK(counts_of(comparison).of(PixelClass::unexplained) == 0);
    CHECK(pixels_by(counts_of(comparison), Cause::mipmap) > 20);
  }
}

TEST_CASE("tracer witness: a texture on what is lit at its vertices", "[Y5][tracer_witness]") {
  const SceneDescription scene = technique_scene(R"({"camera": {"eye": [3, 3, 4]}, "lights": [{"type": "point", "intensity": 0.6, "position": [2, 2.1, 3.5]}],
    "textures": {"t": {"source": "checker", "filter": "bilinear"}}, "materials": {"m": {"model": "lambert", "diffuse": [0.7, 0.5, 0.2], "texture": "t", "mapping": {"repeat": [3, 3]}}},
    "objects": [{"shape": {"type": "torus", "segments": [20, 10]}, "material": "m", "shading": "gouraud"}]})");
  const Comparison comparison = by_both(scene, scene);
  INFO(summary_of(comparison));
  CHECK(counts_of(comparison).of(PixelClass::unexplained) == 0);
  CHECK(pixels_by(counts_of(comparison), Cause::vertex_shading) > 20);
}

TEST_CASE("tracer witness: clear and mirroring bodies do not hide another kt or kr", "[Y5][tracer_witness]") {
  for (const char* index : {"1", "1.5"}) {
    const SceneDescription scene = clear_and_chrome(index);
    const Comparison comparison = by_both(scene, scene);
    INFO(index << "\n" << summary_of(comparison));
    CHECK(counts_of(comparison).of(PixelClass::unexplained) == 0);
    CHECK(unexplained(scene, changed(scene, "glass", [](auto& glass) { glass.transmission *= 0.8F; })) > 200);
    CHECK(unexplained(scene, changed(scene, "chrome", [](auto& chrome) { chrome.mirror *= 0.8F; })) > 200);
  }
}

// What is bent is drawn straight on, whatever the index: that the tracer bends it by another one cannot show.

TEST_CASE("tracer witness: only what is bent is explained by it", "[Y5][tracer_witness]") {
  const SceneDescription straight = clear_and_chrome("1"), bent = clear_and_chrome("1.5"), more_bent = clear_and_chrome("1.8");
  const Comparison of_straight = by_both(straight, straight), of_bent = by_both(bent, bent);
  INFO(summary_of(of_straight) << summary_of(of_bent));
  CHECK(pixels_by(counts_of(of_straight), Cause::transmission) == 0);
  CHECK(pixels_by(counts_of(of_bent), Cause::transmission) > 200);
  CHECK(pixels_by(counts_of(of_bent), Cause::mirror_of_surroundings) > 200);
  CHECK(unexplained(bent, more_bent) == 0);
}

// A tracer that does not follow what goes through: the shadow map's imitation, which does, must not put that right.

TEST_CASE("tracer witness: a wrong ray through a clear body is not hidden by another technique", "[Y5][tracer_witness]") {
  const SceneDescription described = technique_scene(R"({"image": {"background": [0.2, 0.3, 0.5]}, "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0]},
    "lights": [{"type": "directional", "towards": [0, 0.5, 1], "shadow": {"resolution": 32}}],
    "materials": {"pane": {"diffuse": 0.3, "transmission": 0.6, "refractive_index": 1}},
    "objects": [{"shape": {"type": "plane", "width": 9, "depth": 9}, "material": "pane", "transforms": [{"rotate": 90, "about": [1, 0, 0]}]}]})");
  Workers workers(1);
  const auto scene = tracer::TracedScene::create(described, workers, {.surfaces = tracer::SurfaceKind::tessellated});
  REQUIRE(scene);
  const auto camera = camera_of(described.camera, 1.5);
  REQUIRE(camera);
  const auto imitation = Imitation::create(*scene, *camera, kTechniquePixels, workers);
  REQUIRE(imitation);
  const tracer::RayTracer sound(*scene), blind(*scene, {.most_level = 0});
  tracer::TraceScratch scratch;
  const glm::ivec2 pixel(30, 30);
  const DrawnPixel drawn{.colour = Development{}.code(sound.radiance(imitation->ray({.pixel = pixel}), scratch)), .object = 0};
  CHECK(Explaining(*imitation, sound, *camera, {}).verdict(pixel, drawn, scratch).explained);
  CHECK_FALSE(Explaining(*imitation, blind, *camera, {}).verdict(pixel, drawn, scratch).explained);
}

TEST_CASE("tracer witness: bodies that are blended bring a remark", "[Y5][tracer_witness]") {
  SceneDescription scene = clear_and_chrome("1");
  CHECK(by_both(scene, scene).remarks.empty());
  scene = changed(scene, "glass", [](auto& glass) {
    glass.transmission = glm::vec3(0);
    glass.alpha = 0.5F;
  });
  scene.objects[1].name = "bubble";
  const Comparison comparison = by_both(scene, scene);
  REQUIRE(comparison.remarks.size() == 1);
  CHECK(comparison.remarks[0].find("bubble") != std::string::npos);
  CHECK_FALSE(is_confirmed(counts_of(comparison)));
}

}  // namespace tuberia::witness
