// The local model of traced rays, and what stands between a point and its lights.

#include <cmath>

#include "image/image.hpp"
#include "math/colour.hpp"
#include "scene/content/develop.hpp"
#include "tests/ray_tracer/traced_scene_support.hpp"
#include "tests/ray_tracer/whitted_scenes.hpp"

namespace tuberia::tracer {
namespace {

/// A floor, a lamp 4 above its middle, and one ball above or below that.
TracedScene floor_with_lamp(double height_of_ball, const char* more_of_the_ball = "") {
  return whitted_scene(whitted_text(R"({"ambient": 0.1, "lights": [{"type": "point", "position": [0, 4, 0], "intensity": 1, "shadow": {}}],
    "materials": {"floor": {"model": "lambert", "diffuse": 0.8}},
    "objects": [{"name": "floor", "shape": {"type": "plane", "width": 20, "depth": 20}, "material": "floor"},
                {"name": "ball", "shape": {"type": "sphere", "radius": 0.5}, "transforms": [{"translate": [0, )",
                                    height_of_ball, ", 0]}]", more_of_the_ball, "}]}"));
}

constexpr double kInShade = 0.1 * 0.8, kInLight = kInShade + 0.8;

double floor_seen(const TracedScene& scene, const TraceSettings& settings = {}) {
  // From beside the ball, to the point below the lamp.
  return whitted_ray(scene, whitted_towards({3, 1, 0}, {0, 0, 0}), settings).light.x;
}

}  // namespace

TEST_CASE("ray tracer: what is nearer than the light throws a shadow, what is beyond it does not", "[ray_tracer][A43][B58]") {
  CHECK(floor_seen(floor_with_lamp(2)) == Approx(kInShade));
  CHECK(floor_seen(floor_with_lamp(6)) == Approx(kInLight));
  CHECK(floor_seen(floor_with_lamp(4.6)) == Approx(kInLight));
  CHECK(floor_seen(floor_with_lamp(2, R"(, "casts_shadow": false)")) == Approx(kInLight));
}

TEST_CASE("ray tracer: light from afar is stopped at any distance", "[ray_tracer][A43][B58]") {
  const auto scene = [](const char* shadow) {
    return whitted_scene(whitted_text(R"({"ambient": 0.1, "lights": [{"type": "directional", "towards": [0, 1, 0])", shadow, R"(}],
      "materials": {"floor": {"model": "lambert", "diffuse": 0.8}},
      "objects": [{"shape": {"type": "plane", "width": 20, "depth": 20}, "material": "floor"},
                  {"shape": {"type": "sphere"}, "transforms": [{"translate": [0, 5000, 0]}]}]})"));
  };
  CHECK(floor_seen(scene(R"(, "shadow": {})")) == Approx(kInShade));
  // Only lights that say so cast shadows, unless all are to.
  CHECK(floor_seen(scene("")) == Approx(kInLight));
  CHECK(floor_seen(scene(""), {.shadows_of_all = true}) == Approx(kInShade));
}

TEST_CASE("ray tracer: each light has a shadow ray of its own", "[ray_tracer][B58][B52]") {
  const TracedScene scene = whitted_scene(R"({"ambient": 0.1,
    "lights": [{"type": "point", "position": [0, 4, 0], "intensity": 0.5, "shadow": {}}, {"type": "point", "position": [4, 4, 0], "intensity": [0.25, 0.5, 0.75], "shadow": {}},
               {"type": "point", "position": [0, -4, 0], "shadow": {}}],
    "materials": {"floor": {"model": "lambert", "diffuse": 0.8}},
    "objects": [{"shape": {"type": "plane", "width": 20, "depth": 20}, "material": "floor"},
                {"shape": {"type": "sphere", "radius": 0.5}, "transforms": [{"translate": [0, 2, 0]}]}]})");
  const WhittedRay seen = whitted_ray(scene, whitted_towards({3, 1, 0}, {0, 0, 0}));
  // The first is behind the ball, the third below the floor; of the second arrives cos 45 degrees.
  const double cosine = std::sqrt(0.5);
  CHECK(whitted_is_near(seen.light, glm::dvec3(0.08) + 0.8 * cosine * glm::dvec3(0.25, 0.5, 0.75), 1e-7));
  CHECK(seen.scratch.shadow_rays == 2);
  REQUIRE(whitted_named(seen.tree, "L1.1"));
  CHECK(whitted_named(seen.tree, "L1.1")->end == RayEnd::blocked);
  CHECK(whitted_named(seen.tree, "L1.2")->end == RayEnd::lit);
  CHECK_FALSE(whitted_named(seen.tree, "L1.3"));
}

TEST_CASE("ray tracer: the highlight is Blinn and Phong's, where nothing stands in the light", "[ray_tracer][C43]") {
  const auto seen = [](const char* model, double ball) {
    const TracedScene scene = whitted_scene(whitted_text(R"({"ambient": 0, "lights": [{"type": "directional", "towards": [-0.6, 0.8, 0], "shadow": {}}],
      "materials": {"shiny": {"model": ")", model, R"(", "diffuse": 0, "specular": 0.5, "exponent": 10}},
      "objects": [{"shape": {"type": "plane"}, "material": "shiny"}, {"shape": {"type": "sphere", "radius": 0.5}, "transforms": [{"translate": [-3, )", ball, ", 0]}]}]}"));
    return whitted_ray(scene, whitted_towards({0, 5, 0}, {0, 0, 0})).light.x;
  };
  // L = (-.6, .8, 0) and V = N = (0, 1, 0): N.H = sqrt((1 + .8) / 2), R.V = .8.
  CHECK(seen("blinn-phong", 40) == Approx(0.5 * std::pow(0.9, 5)));
  CHECK(seen("phong", 40) == Approx(0.5 * std::pow(0.8, 10)));
  CHECK(seen("blinn-phong", 4) == 0);
  CHECK(seen("phong", 4) == 0);
}

TEST_CASE("ray tracer: where nothing is there is the background, and what is too bright is scaled", "[ray_tracer][C44][A46]") {
  const TracedScene scene = whitted_scene(R"({"image": {"background": [0.1, 0.2, 0.3]}, "ambient": 1.5,
    "materials": {"bright": {"model": "lambert", "diffuse": [1, 0.5, 0.25]}}, "objects": [{"shape": {"type": "sphere"}, "material": "bright"}]})");
  CHECK(whitted_is_near(whitted_ray(scene, whitted_towards({0, 0, 5}, {2, 0, 0})).light, {0.1, 0.2, 0.3}, 1e-7));
  const glm::dvec3 bright = whitted_ray(scene, whitted_towards({0, 0, 5}, {0, 0, 0})).light;
  CHECK(whitted_is_near(bright, {1.5, 0.75, 0.375}, 1e-7));

  description::Picture picture;
  picture.overflow = description::Overflow::hue_preserving;
  Image<Rgba32F> light(1, 1);
  light.at(0, 0) = {static_cast<float>(bright.r), static_cast<float>(bright.g), static_cast<float>(bright.b), 1};
  const Rgba32F shown = developed(light, picture).at(0, 0);
  CHECK(shown.r == Approx(1));
  CHECK(shown.g == Approx(0.5));
  CHECK(shown.b == Approx(0.25));
}

TEST_CASE("ray tracer: the background is looked up by direction", "[ray_tracer][A46]") {
  const TracedScene scene = whitted_scene(R"({"environment": {"source": "sky", "resolution": 64}, "objects": [{"shape": {"type": "sphere"}}]})");
  const glm::dvec3 up = whitted_ray(scene, {.origin = {0, 5, 0}, .direction = {0, 1, 0}}).light;
  const glm::dvec3 down = whitted_ray(scene, {.origin = {0, -5, 0}, .direction = {0, -1, 0}}).light;
  CHECK(up == scene.background({0, 1, 0}, true));
  CHECK(down == scene.background({0, -1, 0}, true));
  CHECK(up != down);
}

TEST_CASE("ray tracer: surfaces that are not opaque show what is straight behind", "[ray_tracer]") {
  // Ten sheets, one behind the other, each of its own grey: over, over and over.
  std::string objects;
  glm::dvec3 expected(0);
  double through = 1;
  for (int i = 0; i < 10; ++i) {
    const double grey = 0.1 * i;
    objects += whitted_text(R"({"shape": {"type": "plane"}, "material": "sheet)", i, R"(", "transforms": [{"translate": [0, )", -i, ", 0]}]},");
    expected += through * 0.25 * grey;
    through *= 0.75;
  }
  objects.back() = ']';
  expected += through * 0.6;
  std::string materials;
  for (int i = 0; i < 10; ++i) materials += whitted_text(i > 0 ? "," : "", "\"sheet", i, R"(": {"alpha": 0.25, "diffuse": )", 0.1 * i, "}");
  const TracedScene scene = whitted_scene(whitted_text(R"({"ambient": 1, "image": {"background": 0.6}, "materials": {)", materials, R"(}, "objects": [)", objects, "}"));
  // They are no level of the recursion.
  const WhittedRay seen = whitted_ray(scene, {.origin = {0.1, 5, 0.1}, .direction = {0, -1, 0}}, {.most_level = 0});
  CHECK(whitted_is_near(seen.light, expected, 1e-6));
  CHECK(seen.scratch.rays_of_this_eye_ray == 11);
  CHECK(whitted_ray(scene, {.origin = {0.1, 5, 0.1}, .direction = {0, -1, 0}}, {.most_rays = 4}).scratch.unfollowed_rays == 1);
}

TEST_CASE("ray tracer: eye and light look through the holes of a leaf", "[ray_tracer]") {
  // A triangle whose picture is gone where x > 1/2, before a wall that is lit from where the eye is.
  const TemporaryFolder folder;
  Image<Rgba8> picture(8, 8, {255, 0, 0, 255});
  for (int y = 0; y < 8; ++y)
    for (int x = 4; x < 8; ++x) picture.at(x, y).a = 0;
  const auto file = traced_test::write_leaf(folder, picture, R"({"alphaMode": "MASK", "alphaCutoff": 0.5, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0}})");
  const TracedScene scene = whitted_scene(whitted_text(R"({"ambient": 0, "lights": [{"type": "directional", "towards": [0, 0, 1], "shadow": {}}], "materials": {"white": {"model": "lambert", "diffuse": 1}},
    "objects": [{"name": "leaf", "shape": {"type": "model", "file": ")", file.string(), R"("}},
                {"name": "wall", "shape": {"type": "plane", "width": 9, "depth": 9}, "material": "white", "transforms": [{"rotate": 90, "about": [1, 0, 0]}, {"translate": [0, 0, -1]}]}]})"));
  const auto seen = [&](double x, double z) { return whitted_ray(scene, {.origin = {x, 0.1, z}, .direction = {0, 0, -1}}, {.most_level = 0}); };
  const WhittedRay hole = seen(0.7, 1), leaf = seen(0.2, 1), behind_leaf = seen(0.2, -0.5), behind_hole = seen(0.7, -0.5);
  CHECK(whitted_is_near(hole.light, glm::dvec3(1), 1e-6));
  CHECK(whitted_is_near(behind_hole.light, glm::dvec3(1), 1e-6));
  CHECK(behind_leaf.light == glm::dvec3(0));
  CAPTURE(leaf.light.r, leaf.light.g, leaf.light.b);
  CHECK(leaf.light.r > 0.5);
  CHECK(leaf.light.g < 0.1 * leaf.light.r);
  CHECK(whitted_named(hole.tree, "P1")->object == "wall");
  CHECK_FALSE(whitted_named(leaf.tree, "P1"));
  TraceScratch scratch;
  const auto first = [&](double x) { return scene.object_of(RayTracer(scene).first_hit({.origin = {x, 0.1, 1}, .direction = {0, 0, -1}}, scratch).item); };
  CHECK(first(0.7) == 1);
  CHECK(first(0.2) == 0);
}

TEST_CASE("ray tracer: texture steps are those to the neighbouring pixels", "[ray_tracer][A44]") {
  // A floor seen obliquely; the neighbours' own hits say where the texture is there.
  const TracedScene scene = whitted_scene(R"({"objects": [{"shape": {"type": "plane", "width": 4, "depth": 6}}]})");
  const Ray ray = whitted_towards({0.3, 1, 3}, {0.2, 0, 0.5}), right = whitted_towards({0.3, 1, 3}, {0.21, 0, 0.5}), down = whitted_towards({0.3, 1, 3}, {0.2, 0, 0.53});
  const auto at = [&](const Ray& seen) {
    Traversal traversal;
    const Hit hit = scene.accelerator().nearest(seen, traversal);
    REQUIRE(hit);
    return scene.geometry().surface(seen, hit);
  };
  const TextureFootprint footprint = footprint_of(at(ray), {.right = right, .down = down});
  CHECK(glm::length(footprint.right - (at(right).texcoord - at(ray).texcoord)) < 1e-9);
  CHECK(glm::length(footprint.down - (at(down).texcoord - at(ray).texcoord)) < 1e-9);
  CHECK(glm::length(footprint.right) > 1e-3);

  // Neighbours that run along the plane never meet it; a surface without coordinates has no steps.
  CHECK(footprint_of(at(ray), {.right = {.origin = {0, 1, 0}, .direction = {1, 0, 0}}, .down = down}).right == glm::dvec2(0));
  SurfacePoint flat = at(ray);
  flat.tangent = flat.bitangent = glm::dvec3(0);
  CHECK(footprint_of(flat, {.right = right, .down = down}).down == glm::dvec2(0));
}

TEST_CASE("ray tracer: textures are filtered where the eye sees them, and at their finest in mirrors", "[ray_tracer][A44]") {
  // Squares of black and white, of which a pixel sees very many; and a mirror that shows them.
  const TracedScene scene = whitted_scene(R"({"ambient": 1, "textures": {"squares": {"source": "checker", "size": 256, "squares": 64}},
    "materials": {"squares": {"texture": "squares", "diffuse": 1}, "mirror": {"diffuse": 0, "mirror": 1}},
    "objects": [{"shape": {"type": "plane"}, "material": "squares"}, {"shape": {"type": "plane"}, "material": "mirror", "transforms": [{"rotate": 180, "about": [1, 0, 0]}, {"translate": [5, 9, 0]}]}]})");
  const RayTracer tracer(scene);
  TraceScratch scratch;
  const auto seen = [&](const glm::dvec3& from, const glm::dvec3& to, double step) {
    const NeighbourRays neighbours{.right = whitted_towards(from, to + glm::dvec3(step, 0, 0)), .down = whitted_towards(from, to + glm::dvec3(0, 0, step))};
    return tracer.radiance(whitted_towards(from, to), scratch, nullptr, &neighbours).x;
  };
  // Squares are 1/32 wide; this point is in the middle of one. The second one is half as far from the mirror's image as from itself.
  const glm::dvec3 square(1.0 / 64, 0, 1.0 / 64), above(square + glm::dvec3(0, 5, 0));
  const double finest = seen(above, square, 1e-4);
  CHECK((finest < 0.01 || finest > 0.99));
  CHECK(seen(above, square, 1) == Approx(0.5).margin(0.05));
  const glm::dvec3 eye(10, 0, 0);
  CHECK(seen(eye, glm::dvec3(5 + square.x / 2, 9, square.z / 2), 1) == Approx(finest).margin(1e-6));
}

}  // namespace tuberia::tracer
