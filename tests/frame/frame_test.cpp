// From a scene file to its light.

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <set>

#include "scene/environment/sky.hpp"
#include "tests/frame/drawn_scene.hpp"
#include "tests/image/temporary_folder.hpp"
#include "tests/support/every_instruction_set.hpp"

namespace tuberia {
namespace {

using test::drawn;
using test::DrawnScene;
using test::scene_from;

/// One of the scenes in examples/scenes, as small as a test needs it.
SceneDescription example_scene(const std::string& name, int width, int height) {
  auto scene = read_scene("examples/scenes/" + name);
  if (!scene) FAIL(scene.error().message);
  scene->picture.width = width;
  scene->picture.height = height;
  scene->picture.supersampling = 1;
  return *scene;
}

/// A little of everything, small.
constexpr const char* kManyThings = R"({
  "image": {"width": 90, "height": 60}, "camera": {"eye": [0, 3, 7], "look_at": [0, 0.5, 0]}, "ambient": 0.2,
  "lights": [{"type": "directional", "towards": [1, 2, 1], "intensity": 0.6, "shadow": {"resolution": 256}},
             {"type": "spot", "position": [-3, 4, 2], "look_at": [0, 0, 0], "shadow": {"resolution": 128, "taps": 3}, "projection": {"texture": "squares"}},
             {"type": "area", "position": [3, 5, -3], "intensity": 0.3, "falloff": "linear", "shadow": {"resolution": 64}}],
  "textures": {"squares": {"source": "random-squares", "size": 64}, "heights": {"source": "gradient", "size": 32}},
  "materials": {"floor": {"model": "lambert", "texture": "squares"}, "shiny": {"specular": 0.5, "mirror": 0.4},
                "rough": {"model": "cook-torrance", "specular": 1, "bump": {"type": "height-texture", "texture": "heights", "gain": 0.1}},
                "glass": {"diffuse": [0.2, 0.5, 0.9], "alpha": 0.5}},
  "environment": {"source": "sky", "resolution": 32},
  "objects": [{"shape": {"type": "plane", "width": 8, "depth": 8}, "material": "floor"},
              {"shape": {"type": "sphere", "segments": [24, 12]}, "material": "shiny", "transforms": [{"translate": [-1.2, 1, 0]}]},
              {"shape": {"type": "torus", "segments": [24, 12]}, "material": "rough", "transforms": [{"translate": [1.5, 0.5, 0]}]},
              {"shape": {"type": "cube"}, "material": "glass", "transforms": [{"scale": 0.5}, {"translate": [0, 0.5, 2]}]}]
})";

}  // namespace

TEST_CASE("frame: a cube in ambient light is one flat colour", "[B06][frame]") {
  const SceneDescription scene = example_scene("01_ambient_light.json", 80, 80);
  const DrawnScene picture = drawn(scene);
  std::set<float> intensities;
  for (const Rgba32F& pixel : picture.light.pixels()) intensities.insert(pixel.r);
  REQUIRE(intensities.size() == 2);  // background and cube
  CHECK(*intensities.begin() == Approx(scene.picture.background.r));
  CHECK(*intensities.rbegin() == Approx(0.6 * 0.75));
  CHECK(picture.passes == std::vector<std::string>{"picture"});
}

TEST_CASE("frame: the middle of each diffuse sphere shows kd", "[B07][frame]") {
  const DrawnScene picture = drawn(example_scene("02_diffuse_reflection.json", 960, 250));
  const float expected[4] = {0.1f, 0.4f, 0.7f, 0.95f};
  for (int i = 0; i < 4; ++i) CHECK(picture.at({-3.45f + 2.3f * static_cast<float>(i), 0, 1}).r == Approx(expected[i]).margin(1e-3));
}

TEST_CASE("frame: where the light does not reach, spheres show kd Ia", "[B08][frame]") {
  const DrawnScene picture = drawn(example_scene("03_ambient_and_diffuse.json", 960, 250));
  const float expected[4] = {0, 0.08f, 0.16f, 0.24f};
  for (int i = 0; i < 4; ++i) CHECK(picture.at({-2.9f + 2.3f * static_cast<float>(i), -0.6f, 0.5f}).r == Approx(expected[i]));
}

TEST_CASE("frame: shadows of directional lights are parallel, of points they spread", "[A14][B02][frame]") {
  const auto scene_with = [](const std::string& light) {
    return scene_from(R"({"image": {"width": 300, "height": 200}, "camera": {"eye": [0, 2, 12], "look_at": [0, 0.5, 0], "fovy_degrees": 30}, "ambient": 0,
      "lights": [)" + light + R"(],
      "materials": {"grey": {"model": "lambert", "diffuse": 0.5}},
      "objects": [{"shape": {"type": "plane", "width": 8, "depth": 8}, "material": "grey"},
                  {"shape": {"type": "disc", "radius": 1}, "material": "grey", "transforms": [{"translate": [0, 5, 0]}]}]})");
  };
  const DrawnScene parallel = drawn(scene_with(R"({"type": "directional", "towards": [0, 1, 0], "shadow": {"taps": 1}})"));
  // Twice as high as the disc: its shadow is twice as wide.
  const DrawnScene spreading = drawn(scene_with(R"({"type": "point", "position": [0, 10, 0], "shadow": {"taps": 1}})"));
  const DrawnScene spot = drawn(scene_with(R"({"type": "spot", "position": [0, 10, 0], "look_at": [0, 0, 0], "cone_degrees": 35, "full_cone_degrees": 34, "shadow": {"taps": 1}})"));
  for (const float x : {-0.9f, 0.0f, 0.9f}) {
    CHECK(parallel.at({x, 0, 0}).r == 0);
    CHECK(spreading.at({x, 0, 0}).r == 0);
  }
  for (const float x : {-1.9f, -1.1f, 1.1f, 1.9f}) {
    CAPTURE(x);
    CHECK(parallel.at({x, 0, 0}).r == Approx(0.5));
    CHECK(spreading.at({x, 0, 0}).r == 0);
    CHECK(spot.at({x, 0, 0}).r == 0);
  }
  for (const float x : {-2.2f, 2.2f}) {
    CHECK(spreading.at({x, 0, 0}).r == Approx(0.5 * 10 / std::sqrt(100 + x * x)).epsilon(1e-3));
    CHECK(spot.at({x, 0, 0}).r == Approx(0.5 * 10 / std::sqrt(100 + x * x)).epsilon(1e-3));
  }
}

TEST_CASE("frame: only what a scene needs is drawn, in this order", "[frame]") {
  const DrawnScene all = drawn(std::string(kManyThings));
  CHECK(all.passes == std::vector<std::string>{"shadows of light 0", "shadows of light 1", "shadows of light 2", "environment", "picture"});
  // Surroundings that nobody sees are not made, even if their file is not there.
  const DrawnScene unseen = drawn(R"({"image": {"width": 8, "height": 8}, "environment": {"source": "panorama", "file": "none.hdr", "shown": false},
    "textures": {"unused": {"file": "none.png"}}, "objects": [{"shape": {"type": "cube"}}]})");
  CHECK(unseen.passes == std::vector<std::string>{"picture"});
}

TEST_CASE("frame: the same bits from all threads and instruction sets", "[frame]") {
  const SceneDescription scene = scene_from(kManyThings);
  const DrawnScene expected = drawn(scene, {.threads = 1, .instruction_set = supported_instruction_sets().front()});
  test::for_every_instruction_set([&](InstructionSet set) {
    for (const int threads : {1, 3}) {
      CAPTURE(threads);
      CHECK((drawn(scene, {.threads = threads, .instruction_set = set}).light == expected.light));
    }
  });
}

TEST_CASE("frame: surroundings are seen behind everything, and in mirrors", "[A36][frame]") {
  const std::string beginning = R"({"image": {"width": 60, "height": 60}, "camera": {"type": "orthographic", "eye": [0, 0, 5], "height": 4}, "ambient": 0,
    "materials": {"mirror": {"diffuse": 0, "mirror": 1}},
    "environment": {"source": "sky", "resolution": 64, "sky": {"zenith": [0, 0, 1], "horizon": [0, 0, 1], "ground": [1, 0, 0], "sun": 0, "glow": 0, "cloudiness": 0})";
  const std::string end = R"(}, "objects": [{"shape": {"type": "sphere"}, "material": "mirror"}]})";
  const DrawnScene shown = drawn(beginning + end);
  // The ball's upper half mirrors the sky, its lower half the ground.
  const Sky sky{.sun = glm::dvec3(0), .glow = glm::dvec3(0), .zenith = {0, 0, 1}, .horizon = {0, 0, 1}, .ground = {1, 0, 0}, .cloudiness = 0};
  for (const float y : {0.5f, -0.5f}) {
    CAPTURE(y);
    const glm::dvec3 normal(0, y, std::sqrt(0.75)), mirrored = 2 * normal.z * normal - glm::dvec3(0, 0, 1);
    const glm::dvec3 expected = sky_radiance(sky, mirrored);
    const Rgba32F pixel = shown.at({0, y, 0.8f});
    CHECK(pixel.r == Approx(expected.r).margin(0.02));
    CHECK(pixel.b == Approx(expected.b).margin(0.02));
  }
  CHECK(shown.at({0, 0.5f, 0.8f}).b > shown.at({0, 0.5f, 0.8f}).r + 0.2f);
  CHECK(shown.at({0, -0.5f, 0.8f}).r > shown.at({0, -0.5f, 0.8f}).b + 0.2f);
  const auto brightness = [](const Rgba32F& pixel) { return pixel.r + pixel.g + pixel.b; };
  CHECK(brightness(shown.at({1.8f, 1.8f, 0})) > 0.5f);
  const DrawnScene hidden = drawn(beginning + R"(, "shown": false)" + end);
  CHECK(brightness(hidden.at({1.8f, 1.8f, 0})) == 0);
  CHECK(hidden.at({0, 0.5f, 0.8f}) == shown.at({0, 0.5f, 0.8f}));
  // All kinds of maps show the same.
  for (const std::string kind : {"sphere", "panorama"}) {
    CAPTURE(kind);
    const DrawnScene other = drawn(beginning + R"(, "look_up": ")" + kind + '"' + end);
    CHECK(other.at({0, 0.5f, 0.8f}).b == Approx(shown.at({0, 0.5f, 0.8f}).b).margin(0.02));
    CHECK(other.at({0, -0.5f, 0.8f}).r == Approx(shown.at({0, -0.5f, 0.8f}).r).margin(0.02));
  }
}

TEST_CASE("frame: an environment can be rendered from the scene itself", "[A30][frame]") {
  const DrawnScene picture = drawn(R"({"image": {"width": 60, "height": 60}, "camera": {"eye": [0, 0, 6]}, "ambient": 1,
    "materials": {"mirror": {"diffuse": 0, "mirror": 1}, "red": {"model": "lambert", "diffuse": [1, 0, 0]}, "blue": {"model": "lambert", "diffuse": [0, 0, 1]}},
    "environment": {"source": "rendered", "resolution": 64, "shown": false},
    "objects": [{"shape": {"type": "sphere"}, "material": "mirror", "seen_in_environment": false},
                {"shape": {"type": "plane", "width": 20, "depth": 20}, "material": "red", "transforms": [{"translate": [0, -4, 0]}]},
                {"shape": {"type": "plane", "width": 20, "depth": 20}, "material": "blue", "transforms": [{"translate": [0, 4, 0]}]}]})");
  CHECK(picture.at({0, 0.6f, 0.8f}).b > 0.9f);
  CHECK(picture.at({0, 0.6f, 0.8f}).r < 0.1f);
  CHECK(picture.at({0, -0.6f, 0.8f}).r > 0.9f);
}

TEST_CASE("frame: a light of an area is the sum of its points", "[B02][frame]") {
  const auto floor_with = [](const std::string& lights) {
    return drawn(R"({"image": {"width": 40, "height": 40}, "camera": {"eye": [0, 5, 0.1]}, "ambient": 0, "materials": {"grey": {"model": "lambert", "diffuse": 0.5}},
      "objects": [{"shape": {"type": "plane"}, "material": "grey"}], "lights": [)" + lights + "]}");
  };
  const DrawnScene area = floor_with(R"({"type": "area", "position": [0, 3, 0], "edge_u": [2, 0, 0], "edge_v": [0, 0, 4], "samples": 2, "intensity": 4})");
  const DrawnScene points = floor_with(R"({"type": "point", "position": [-0.5, 3, -1]}, {"type": "point", "position": [0.5, 3, -1]},
                                          {"type": "point", "position": [-0.5, 3, 1]}, {"type": "point", "position": [0.5, 3, 1]})");
  CHECK((area.light == points.light));
}

TEST_CASE("frame: transforms are done in the order of the file", "[frame]") {
  const DrawnScene picture = drawn(R"({"image": {"width": 60, "height": 60}, "camera": {"type": "orthographic", "height": 6}, "ambient": 1,
    "objects": [{"shape": {"type": "cube", "size": 0.5}, "transforms": [{"translate": [1, 0, 0]}, {"scale": 2}, {"rotate": 90, "about": [0, 0, 1]}]}]})");
  CHECK(picture.at({0, 2, 0}).r == Approx(0.8));
  CHECK(picture.at({2, 0, 0}).r == 0);
}

TEST_CASE("frame: pictures that are made are those that were asked for", "[frame]") {
  const auto texture = [](const std::string& text) {
    const SceneDescription scene = scene_from(R"({"textures": {"t": )" + text + "}}");
    const auto ready = frame_texture(scene, scene.textures.at(0));
    if (!ready) FAIL(ready.error().message);
    return *ready;
  };
  const FrameTexture checker = texture(R"({"source": "checker", "size": 8, "squares": 2, "first": [1, 0, 0], "second": [0, 0, 1], "filter": "nearest", "wrap": "mirror"})");
  CHECK(checker.texture->encoding() == TextureEncoding::srgb);
  const Image<Rgba8> codes = checker.texture->level_image(0);
  CHECK(codes.at(0, 0) == Rgba8{255, 0, 0, 255});
  CHECK(codes.at(3, 4) == Rgba8{0, 0, 255, 255});
  CHECK(codes.at(7, 7) == Rgba8{255, 0, 0, 255});
  CHECK(checker.sampler.texels == TexelFilter::nearest);
  CHECK(checker.sampler.mipmaps == MipmapFilter::none);
  CHECK(checker.sampler.wrap_u == Wrap::mirror);
  const FrameTexture gradient = texture(R"({"source": "gradient", "size": 4, "first": 0, "second": 1, "level_rule": "distance", "texel_distance": 3})");
  for (int x = 0; x < 4; ++x) CHECK(gradient.texture->float_level_image(0).at(x, 2).g == (static_cast<float>(x) + 0.5f) / 4);
  CHECK(gradient.access.level_rule == TextureAccess::LevelRule::distance);
  CHECK(gradient.access.texel_distance == 3);
  const FrameTexture planet = texture(R"({"source": "planet", "size": 16})");
  CHECK(planet.texture->level(0).width == 32);
  CHECK(planet.texture->encoding() == TextureEncoding::srgb);
  CHECK(texture(R"({"source": "brick-heights", "size": 16})").texture->encoding() == TextureEncoding::linear);
  const FrameTexture levels = texture(R"({"source": "checker", "size": 8, "level_colours": true})");
  CHECK(levels.texture->level_image(0).at(0, 0) != levels.texture->level_image(1).at(0, 0));
  CHECK(levels.texture->level(0).width == 8);
}

TEST_CASE("frame: the camera moves while the time runs", "[C02][C16][frame]") {
  const SceneDescription scene = scene_from(R"({"camera": {"eye": [0, 0, 5], "motions": [{"type": "orbit", "right_degrees": 90}, {"type": "dolly", "distance": 2},
    {"type": "zoom", "factor": 2}]}})");
  const Camera half = *camera_of(scene.camera, 1, 0.5), end = *camera_of(scene.camera, 1, 1), start = *camera_of(scene.camera, 1);
  CHECK(start.eye == glm::dvec3(0, 0, 5));
  CHECK(glm::distance(half.eye, 4 * std::sqrt(0.5) * glm::dvec3(1, 0, 1)) < 1e-9);
  CHECK(glm::distance(end.eye, glm::dvec3(3, 0, 0)) < 1e-9);
  CHECK(end.view.top == Approx(start.view.top / 2));
  CHECK(half.view.top == Approx(start.view.top / std::sqrt(2)));
}

TEST_CASE("frame: a model file is drawn with its own materials or the object's", "[frame]") {
  const TemporaryFolder folder;
  folder.write("one.mtl", "newmtl red\nKd 1 0 0\n");
  folder.write("one.obj", "mtllib one.mtl\nusemtl red\nv 10 10 10\nv 30 10 10\nv 10 30 10\nv 30 30 10\nf 1 2 4\nf 1 4 3\n");
  const auto scene = [&](const std::string& own) {
    return *read_scene(folder.write("scene.json", R"({"image": {"width": 20, "height": 20}, "camera": {"type": "orthographic", "height": 2}, "ambient": 1,
      "materials": {"green": {"diffuse": [0, 1, 0]}}, "objects": [{"shape": {"type": "model", "file": "one.obj", "unit_size": true, "own_materials": )" + own + R"(}, "material": "green"}]})"));
  };
  CHECK(drawn(scene("true")).light.at(10, 10) == Rgba32F{1, 0, 0, 1});
  CHECK(drawn(scene("false")).light.at(10, 10) == Rgba32F{0, 1, 0, 1});
}

TEST_CASE("frame: a pixel is the mean of its samples", "[frame]") {
  SceneDescription scene = scene_from(R"({"image": {"width": 32, "height": 32}, "camera": {"type": "orthographic", "height": 4}, "ambient": 1, "objects": [{"shape": {"type": "sphere"}}]})");
  // A circle of radius 8 pixels crosses 60 of them; few so little that no sample or all of them are inside.
  const auto between = [&] {
    int count = 0;
    const DrawnScene picture = drawn(scene);
    for (const Rgba32F& pixel : picture.light.pixels()) count += pixel.r > 0.01f && pixel.r < 0.79f;
    return count;
  };
  CHECK(between() == 0);
  scene.picture.supersampling = 4;
  CHECK(between() > 40);
}

TEST_CASE("frame: every example is read and drawn, but for what only rays can show", "[frame]") {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("examples/scenes")) {
    if (entry.path().extension() != ".json") continue;
    CAPTURE(entry.path());
    SceneDescription scene = example_scene(entry.path().filename().string(), 40, 30);
    CHECK_FALSE(scene.title.empty());
    CHECK_FALSE(scene.caption.empty());
    CHECK_FALSE(scene.source.empty());
    const auto is_infinite = [](const description::Object& object) { return std::holds_alternative<description::InfinitePlane>(object.shape); };
    if (std::any_of(scene.objects.begin(), scene.objects.end(), is_infinite)) continue;
    const DrawnScene picture = drawn(scene);
    std::set<float> intensities;
    for (const Rgba32F& pixel : picture.light.pixels()) intensities.insert(pixel.r + pixel.g + pixel.b);
    CHECK(intensities.size() > 1);
    ++count;
  }
  CHECK(count >= 6);
}

}  // namespace tuberia
