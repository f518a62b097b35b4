// Scene files that are right.

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "scene/description/read_scene.hpp"
#include "tests/image/temporary_folder.hpp"
#include "tests/scene/every_key.hpp"

namespace tuberia {
namespace {

using namespace description;

SceneDescription scene_of(const std::string& text) {
  const auto scene = scene_from_json(text, "scene.json");
  if (!scene) FAIL(scene.error().message);
  return *scene;
}

}  // namespace

TEST_CASE("scene file: nothing at all is a scene of defaults", "[scene][scene_file]") {
  CHECK(scene_of("{}") == SceneDescription{});
  CHECK(scene_of("\xef\xbb\xbf { \r\n } \n") == SceneDescription{});  // a byte order mark before it
}

TEST_CASE("scene file: objects, observer and lights, with geometry and physics", "[C02][B01][scene][scene_file]") {
  const SceneDescription scene = scene_of(R"({
    "title": "One ball", "caption": "A highlight", "source": "B Figure 13",
    "image": {"width": 320, "height": 200, "overflow": "hue-preserving", "exposure_stops": -1, "background": 0.25},
    "camera": {"eye": [1, 2, 3], "look_at": [0, 1, 0], "up": [0, 0, 1], "fovy_degrees": 30, "near": 0.5, "far": 20},
    "ambient": [0.1, 0.2, 0.3],
    "lights": [{"type": "point", "position": [4, 5, 6], "intensity": 2, "falloff": "linear", "falloff_distance": 3, "shadow": {"taps": 3}},
               {"type": "directional", "towards": [0, 1, 0]}],
    "materials": {"red": {"diffuse": [0.4, 0, 0], "specular": 0.5, "exponent": 10}},
    "objects": [{"shape": {"type": "sphere", "radius": 2}, "material": "red", "shading": "gouraud",
                 "transforms": [{"scale": 2}, {"rotate": 90, "about": [0, 1, 0]}, {"translate": [1, 0, 0]}]}]
  })");
  CHECK(scene.title == "One ball");
  CHECK(scene.caption == "A highlight");
  CHECK(scene.source == "B Figure 13");
  CHECK(scene.picture == Picture{.width = 320, .height = 200, .background = glm::vec3(0.25f), .exposure_stops = -1, .overflow = Overflow::hue_preserving});
  CHECK(scene.camera == Camera{.eye = {1, 2, 3}, .look_at = {0, 1, 0}, .up = {0, 0, 1}, .fovy_degrees = 30, .near_distance = 0.5, .far_distance = 20, .motions = {}});
  CHECK(scene.ambient == glm::vec3(0.1f, 0.2f, 0.3f));
  REQUIRE(scene.lights.size() == 2);
  CHECK(scene.lights[0].kind == Light::Kind::point);
  CHECK(scene.lights[0].position == glm::dvec3(4, 5, 6));
  CHECK(scene.lights[0].intensity == glm::vec3(2));
  CHECK(scene.lights[0].falloff == Light::Falloff::linear);
  CHECK(scene.lights[0].falloff_distance == 3);
  REQUIRE(scene.lights[0].shadow.has_value());
  CHECK(scene.lights[0].shadow->taps == 3);
  CHECK(scene.lights[1].towards == glm::dvec3(0, 1, 0));
  CHECK_FALSE(scene.lights[1].shadow.has_value());
  REQUIRE(scene.materials.size() == 1);
  CHECK(scene.materials[0].name == "red");
  CHECK_FALSE(scene.materials[0].ambient.has_value());
  CHECK(scene.materials[0].exponent == 10);
  REQUIRE(scene.objects.size() == 1);
  CHECK(std::get<Sphere>(scene.objects[0].shape).radius == 2);
  CHECK(scene.objects[0].shading == Shading::gouraud);
  REQUIRE(scene.objects[0].transforms.size() == 3);
  CHECK(scene.objects[0].transforms[0] == Transform{.kind = Transform::Kind::scale, .vector = {2, 2, 2}});
  CHECK(scene.objects[0].transforms[1] == Transform{.kind = Transform::Kind::rotate, .vector = {0, 1, 0}, .degrees = 90});
  CHECK(scene.objects[0].transforms[2] == Transform{.kind = Transform::Kind::translate, .vector = {1, 0, 0}});
}

TEST_CASE("scene file: a matrix is its rows", "[scene][scene_file]") {
  const SceneDescription scene = scene_of(R"({"objects": [{"shape": {"type": "cube"},
    "transforms": [{"matrix": [[1, 2, 3, 4], [5, 6, 7, 8], [9, 10, 11, 12], [0, 0, 0, 1]]}]}]})");
  const glm::dmat4& matrix = scene.objects.at(0).transforms.at(0).matrix;
  CHECK(matrix * glm::dvec4(0, 0, 0, 1) == glm::dvec4(4, 8, 12, 1));
  CHECK(matrix * glm::dvec4(1, 0, 0, 0) == glm::dvec4(1, 5, 9, 0));
}

TEST_CASE("scene file: what is written reads as the same scene", "[scene][scene_file]") {
  for (const std::string text : {"{}", kEveryKey, kOtherKeys, kPanorama, kRendered}) {
    CAPTURE(text);
    const SceneDescription scene = scene_of(text);
    const std::string written = json_of_scene(scene);
    CHECK(scene_of(written) == scene);
    CHECK(json_of_scene(scene_of(written)) == written);
  }
}

TEST_CASE("scene file: every key of the page stands in one of the scenes above", "[scene][scene_file]") {
  // So the round trip above has tried them all, and this test fails when a key is new.
  const std::string page = scene_file_page();
  const std::string tried = std::string(kEveryKey) + kOtherKeys + kPanorama + kRendered;
  int count = 0;
  for (std::size_t at = page.find("\n| `"); at != std::string::npos; at = page.find("\n| `", at + 1)) {
    const std::string key = page.substr(at + 4, page.find('`', at + 4) - at - 4);
    CAPTURE(key);
    CHECK(tried.find('"' + key + '"') != std::string::npos);
    ++count;
  }
  CHECK(count > 100);
}

TEST_CASE("scene file: the page in docs is the one of this reader", "[scene][scene_file]") {
  std::ifstream file("docs/scene_file.md", std::ios::binary);
  const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  CHECK((page == scene_file_page()));  // otherwise: tuberia info --scene-keys > docs/scene_file.md
}

TEST_CASE("scene file: files are looked for beside the scene", "[scene][scene_file]") {
  const TemporaryFolder folder;
  const auto scene = read_scene(folder.write("scenes/one.json", R"({"textures": {"a": {"file": "wood.png"}}})"));
  REQUIRE(scene.ok());
  CHECK(file_of(*scene, scene->textures.at(0).file) == folder / "scenes/wood.png");
  CHECK(file_of(*scene, "/elsewhere/wood.png") == "/elsewhere/wood.png");
}

TEST_CASE("scene file: any change of a letter gives a scene or an error of one line", "[scene][scene_file]") {
  const unsigned seed = 20;
  std::mt19937 random(seed);
  const std::string good = kEveryKey;
  const std::string letters = "{}[]\",:0-9e.\n\\x\x01";
  int refused = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::string text = good;
    const std::size_t at = random() % text.size();
    if (trial % 3 == 0) text[at] = letters[random() % letters.size()];
    if (trial % 3 == 1) text.erase(at, 1 + random() % 9);
    if (trial % 3 == 2) text.insert(at, 1, letters[random() % letters.size()]);
    const auto scene = scene_from_json(text, "scene.json");
    if (scene) continue;
    ++refused;
    CAPTURE(seed, trial, scene.error().message);
    REQUIRE(one_line_naming(scene.error().message, "scene.json:"));
  }
  CHECK(refused > 1000);
}

}  // namespace tuberia
