// Whole pictures of the recursion: one scene with a surface of each kind.

#include <functional>

#include "reference/ray_tracer/render.hpp"
#include "scene/content/develop.hpp"
#include "scene/content/scene_camera.hpp"
#include "tests/golden/golden.hpp"
#include "tests/ray_tracer/whitted_scenes.hpp"

namespace tuberia::tracer {
namespace {

SceneDescription one_of_each() {
  auto scene = read_scene("examples/scenes/60_one_of_each.json");
  if (!scene) FAIL(scene.error().message);
  scene->picture.width = 108;
  scene->picture.height = 66;
  for (description::Texture& texture : scene->textures) texture.size = 128;
  scene->tracing.sampling = {};
  return *std::move(scene);
}

description::Material& material_named(SceneDescription& scene, std::string_view name) {
  for (description::Material& material : scene.materials)
    if (material.name == name) return material;
  FAIL("no material " << name);
  return scene.materials.front();
}

TracedPicture pictured(const SceneDescription& description, int threads = 1, const TracedSceneOptions& options = {}) {
  const TracedScene scene = whitted_scene(description, options);
  const description::Picture& picture = description.picture;
  const View view = *View::create(*camera_of(description.camera, static_cast<double>(picture.width) / picture.height), picture.width, picture.height);
  Workers workers(threads);
  return render(RayTracer(scene, {.most_level = description.tracing.depth}), view, picture.width, picture.height, description.tracing.sampling, workers);
}

int differing_pixels(const Image<Rgba32F>& a, const Image<Rgba32F>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i)
    count += std::max({std::abs(a.pixels()[i].r - b.pixels()[i].r), std::abs(a.pixels()[i].g - b.pixels()[i].g), std::abs(a.pixels()[i].b - b.pixels()[i].b)}) > 0.01f;
  return count;
}

}  // namespace

TEST_CASE("ray tracer: one scene shows all that the notes' tracer covers", "[ray_tracer][A40]") {
  const TracedPicture whole = pictured(one_of_each());
  for (const Rgba32F& pixel : whole.light.pixels()) CHECK((std::isfinite(pixel.r) && pixel.r >= 0 && std::isfinite(pixel.g) && std::isfinite(pixel.b)));
  CHECK(whole.counts.reflected_rays > 200);
  CHECK(whole.counts.transmitted_rays > 200);
  CHECK(whole.counts.shadow_rays > 5'000);

  // Each technique is in it: without it the picture is another one.
  struct Technique {
    const char* name;
    std::function<void(SceneDescription&)> leave_out;
  };
  const Technique techniques[] = {{"diffuse", [](SceneDescription& s) { material_named(s, "diffuse").diffuse = glm::vec3(0); }},
                                  {"specular", [](SceneDescription& s) { material_named(s, "glossy").specular = glm::vec3(0); }},
                                  {"texture", [](SceneDescription& s) { material_named(s, "planet").texture.clear(); }},
                                  {"bump", [](SceneDescription& s) { material_named(s, "wall").bump.reset(); }},
                                  {"shadows", [](SceneDescription& s) { for (auto& light : s.lights) light.shadow.reset(); }},
                                  {"transparent", [](SceneDescription& s) { material_named(s, "glass").transmission = glm::vec3(0); }},
                                  {"refraction", [](SceneDescription& s) { material_named(s, "glass").refractive_index = glm::vec3(1); }},
                                  {"mirror", [](SceneDescription& s) { material_named(s, "mirror").mirror = glm::vec3(0); }}};
  for (const Technique& technique : techniques) {
    CAPTURE(technique.name);
    SceneDescription without = one_of_each();
    technique.leave_out(without);
    CHECK(differing_pixels(whole.light, pictured(without).light) > 10);
  }
}

TEST_CASE("ray tracer: the picture of it", "[ray_tracer][A40][C43]") {
  auto scene = read_scene("examples/scenes/60_one_of_each.json");
  REQUIRE(scene.ok());
  scene->picture.width = 216;
  scene->picture.height = 132;
  const TracedPicture traced = pictured(*scene, 2);
  test::GoldenFolders folders;
  folders.golden /= "rays";
  CHECK(test::golden_difference("one_of_each", srgb_codes_of(developed(traced.light, scene->picture)), folders, {.codes = 1, .share_of_pixels = 1e-3}) == "");
}

TEST_CASE("ray tracer: accelerators and threads change nothing in it", "[ray_tracer][A40]") {
  SceneDescription scene = one_of_each();
  scene.picture.width = 54;
  scene.picture.height = 33;
  const TracedPicture whole = pictured(scene);
  for (const AcceleratorKind kind : {AcceleratorKind::none, AcceleratorKind::bounding_spheres, AcceleratorKind::grid, AcceleratorKind::octree}) {
    CAPTURE(name_of(kind));
    const TracedPicture other = pictured(scene, 2, {.accelerator = kind});
    CHECK(other.light == whole.light);
    CHECK(other.counts.reflected_rays == whole.counts.reflected_rays);
    CHECK(other.counts.shadow_rays == whole.counts.shadow_rays);
  }
}

}  // namespace tuberia::tracer
