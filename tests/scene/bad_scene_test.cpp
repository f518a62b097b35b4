// Scene files that are refused, and what the refusal says: one for each kind of mistake.

#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "scene/description/read_scene.hpp"
#include "tests/image/temporary_folder.hpp"

namespace tuberia {
namespace {

struct BadScene {
  std::string text, complaint;  // the whole of it, after the file's name
};

void check_refused_scenes(const std::vector<BadScene>& scenes) {
  for (const BadScene& bad : scenes) {
    CAPTURE(bad.text);
    const auto scene = scene_from_json(bad.text, "bad.json");
    REQUIRE(!scene.ok());
    CHECK(scene.error().message == "bad.json:" + bad.complaint);
  }
}

void check_refused_beginning(const std::string& text, const std::string& beginning) {
  const auto scene = scene_from_json(text, "bad.json");
  CAPTURE(text);
  REQUIRE(!scene.ok());
  CAPTURE(scene.error().message);
  CHECK(scene.error().message.starts_with("bad.json:" + beginning));
  CHECK(one_line_naming(scene.error().message, beginning));
}

}  // namespace

TEST_CASE("scene file: bad syntax is refused with line and column", "[scene][scene_file][refused]") {
  check_refused_beginning("", "1:1: it is no JSON: ");
  check_refused_beginning("{\n  \"ambient\": 1,\n}", "3:1: it is no JSON: ");
  check_refused_beginning("{\n  \"ambient\" 1}", "2:13: it is no JSON: ");
  check_refused_beginning("{\"title\": \"two\nlines\"}", "1:15: it is no JSON: ");
  check_refused_beginning("{\"title\": \"\xff\"}", "1:12: it is no JSON: ");
  check_refused_beginning("{\"ambient\": .5}", "1:13: it is no JSON: ");
  check_refused_beginning("{\"ambient\": NaN}", "1:13: it is no JSON: ");
  check_refused_beginning("{} {}", "1:4: it is no JSON: ");
  check_refused_beginning("{\"lights\": [", "1:12: it is no JSON: ");
  check_refused_beginning("{\n\n\"ambient\": 1e999}", "3:16: number 1e999 is too large");
  check_refused_beginning(std::string(100, '[') + std::string(100, ']'), "1: lists and objects are nested more than 64 deep");
}

TEST_CASE("scene file: keys that are unknown or there twice are refused", "[scene][scene_file][refused]") {
  check_refused_scenes({
      {"[]", "1: the scene is a list, but must be an object"},
      {"{\n \"ambeint\": 1}", "2: ambeint is no key that belongs here; did you mean 'ambient'?"},
      {"{\"ambient\": 1,\n \"title\": \"\",\n \"ambient\": 1}", "3: key 'ambient' is there twice"},
      {"{\"materials\": {\"red\": {},\n \"red\": {}}}", "2: key 'red' is there twice"},
      {"{\"materials\": {\n\"red\": {\n\"exponnet\": 3}}}", "3: materials.red.exponnet is no key that belongs here; did you mean 'exponent'?"},
      {"{\"image\": {\"size\": 3}}", "1: image.size is no key that belongs here; there could be width, height, supersampling, background, exposure_stops or overflow"},
      {"{\"materials\": {\"red\": {\"model\": \"lambert\",\n \"exponent\": 3}}}",
       "2: materials.red.exponent is no key that belongs here; there could be model, diffuse, ambient, transmission, texture, pattern, mapping, bump, mirror, alpha or two_sided"},
      {"{\"materials\": {\"\": {}}}", "1: materials has an empty name"},
  });
}

TEST_CASE("scene file: values of the wrong kind or out of range are refused", "[scene][scene_file][refused]") {
  check_refused_scenes({
      {"{\n\"materials\": {\n\"red\": {\n\"exponent\": -3\n}}}", "4: materials.red.exponent is -3, but must be 0 or more"},
      {"{\"materials\": {\"red\": {\"exponent\": \"10\"}}}", "1: materials.red.exponent is a text, but must be a number"},
      {"{\"materials\": {\"red\": {\"roughness\": 0, \"model\": \"cook-torrance\"}}}", "1: materials.red.roughness is 0, but must be from 0.001 to 1000"},
      {"{\"materials\": {\"red\": {\"alpha\": 1.5}}}", "1: materials.red.alpha is 1.5, but must be from 0 to 1"},
      {"{\"materials\": {\"red\": {\"diffuse\": [1, 2]}}}", "1: materials.red.diffuse is a list of 2, but must be a number or a list of 3 numbers"},
      {"{\"materials\": {\"red\": {\"diffuse\": [1,\n -2, 3]}}}", "2: materials.red.diffuse[1] is -2, but must be 0 or more"},
      {"{\"materials\": {\"red\": {\"model\": \"ward\"}}}", "1: materials.red.model is 'ward', but must be lambert, phong, blinn-phong, weighted-phong or cook-torrance"},
      {"{\"materials\": []}", "1: materials is a list, but must be an object"},
      {"{\"materials\": {\"red\": 5}}", "1: materials.red is a number, but must be an object"},
      {"{\"lights\": [\n{\"type\": \"point\"},\n7]}", "3: lights[1] is a number, but must be an object"},
      {"{\"camera\": {\"eye\": 3}}", "1: camera.eye is a number, but must be a list of 3 numbers"},
      {"{\"camera\": {\"eye\": [1e31, 0, 0]}}", "1: camera.eye[0] is 1e+31, which is too large"},
      {"{\"camera\": {\"fovy_degrees\": 180}}", "1: camera.fovy_degrees is 180, but must be more than 0 to less than 180"},
      {"{\"image\": {\"width\": 2.5}}", "1: image.width is 2.5, but must be a whole number"},
      {"{\"image\": {\"width\": 0}}", "1: image.width is 0, but must be from 1 to 16384"},
      {"{\"title\": null}", "1: title is null, but must be a text"},
      {"{\"environment\": {\"source\": \"sky\", \"shown\": 1}}", "1: environment.shown is a number, but must be true or false"},
  });
}

TEST_CASE("scene file: what must be there and is not is refused", "[scene][scene_file][refused]") {
  check_refused_scenes({
      {"{\"objects\": [\n{}]}", "2: objects[0].shape is missing"},
      {"{\"lights\": [{}]}", "1: lights[0].type is missing"},
      {"{\"textures\": {\"wall\": {}}}", "1: textures.wall.file is missing"},
      {"{\"textures\": {\"wall\": {\"file\": \"\"}}}", "1: textures.wall.file is empty"},
      {"{\"environment\": {\"source\": \"faces\",\n\"faces\": {\"+x\": \"a\", \"-x\": \"b\", \"+y\": \"c\", \"-y\": \"d\", \"+z\": \"e\"}}}", "2: environment.faces.-z is missing"},
      {"{\"objects\": [{\"shape\": {\"type\": \"height-field\"}}]}", "1: objects[0].shape.heights is missing, and there is no texture either"},
      {"{\"objects\": [{\"shape\": {\"type\": \"cube\"}, \"transforms\": [{}]}]}", "1: objects[0].transforms[0] is none of translate, rotate, scale or matrix"},
  });
}

TEST_CASE("scene file: names of what is not there are refused", "[scene][scene_file][refused]") {
  check_refused_scenes({
      {"{\"objects\": [{\"shape\": {\"type\": \"cube\"},\n\"material\": \"red\"}]}", "2: objects[0].material is 'red', but there is no material of that name"},
      {"{\"materials\": {\"red\": {\"texture\": \"wall\"}}}", "1: materials.red.texture is 'wall', but there is no texture of that name"},
      {"{\"materials\": {\"red\": {\"bump\": {\"type\": \"normal-map\", \"texture\": \"n\"}}}}", "1: materials.red.bump.texture is 'n', but there is no texture of that name"},
      {"{\"lights\": [{\"type\": \"point\", \"projection\": {\"texture\": \"slide\"}}]}", "1: lights[0].projection.texture is 'slide', but there is no texture of that name"},
  });
}

TEST_CASE("scene file: values that do not go together are refused", "[scene][scene_file][refused]") {
  const std::string shape = "{\"objects\": [{\"shape\": {\"type\": ", mesh = shape + "\"mesh\", \"positions\": [[0,0,0],[1,0,0],[0,1,0]],\n";
  check_refused_scenes({
      {"{\"camera\": {\"eye\": [0, 5, 0], \"look_at\": [0, 0, 0]}}", "1: camera.up is parallel to the line of sight"},
      {"{\"camera\": {\"up\": [0, 0, 0]}}", "1: camera.up is parallel to the line of sight"},
      {"{\"camera\": {\"eye\": [1, 1, 1],\n\"look_at\": [1, 1, 1]}}", "2: camera.look_at is where the eye stands"},
      {"{\"textures\": {\"wall\": {\"source\": \"bricks\", \"squares\": 7}}}", "1: textures.wall.squares is odd, but courses of bricks must be even"},
      {"{\"camera\": {\"near\": 3,\n\"far\": 2}}", "2: camera.far is not beyond near"},
      {"{\"lights\": [{\"type\": \"directional\", \"towards\": [0, 0, 0]}]}", "1: lights[0].towards is no direction"},
      {"{\"lights\": [{\"type\": \"spot\", \"position\": [0, 1, 0], \"look_at\": [0, 1, 0]}]}", "1: lights[0].look_at is where the light is"},
      {"{\"lights\": [{\"type\": \"spot\", \"cone_degrees\": 10}]}", "1: lights[0].full_cone_degrees is more than cone_degrees"},
      {"{\"materials\": {\"a\": {\"mapping\": {\"type\": \"sphere\", \"pole\": [1, 1, 0]}}}}", "1: materials.a.mapping.equator is not perpendicular to the pole"},
      {"{\"textures\": {\"t\": {\"source\": \"checker\"}}, \"materials\": {\"a\": {\"texture\": \"t\", \"pattern\": {\"type\": \"wood\"}}}}",
       "1: materials.a.pattern is there beside a texture"},
      {mesh + "\"triangles\": [[0, 1, 3]]}}]}", "2: objects[0].shape.triangles has the index 3, but the mesh has 3 vertices"},
      {mesh + "\"triangles\": [[0, 1, 1.5]]}}]}", "2: objects[0].shape.triangles has the index 1.5, but the mesh has 3 vertices"},
      {mesh + "\"triangles\": [[0, 1]]}}]}", "2: objects[0].shape.triangles[0] is a list of 2, but must be a list of 3 numbers"},
      {mesh + "\"normals\": [[0,0,1]], \"triangles\": []}}]}", "2: objects[0].shape.normals is not one for each position"},
      {shape + "\"height-field\", \"heights\": [[0, 1], [0]]}}]}", "1: objects[0].shape.heights[1] is a list of 1, but must be a list of 2 numbers"},
      {shape + "\"height-field\", \"heights\": [[0, 1]]}}]}", "1: objects[0].shape.heights is smaller than 2 rows of 2"},
      {shape + "\"bezier-patches\", \"patches\": [{\"points\": [[0,0,0]]}]}}]}", "1: objects[0].shape.patches[0].points is not of 16 points"},
      {shape + "\"sphere\", \"segments\": [8, 2.5]}}]}", "1: objects[0].shape.segments is not of whole numbers"},
      {shape + "\"torus\", \"segments\": [8, 2]}}]}", "1: objects[0].shape.segments is less than [3, 3]"},
      {shape + "\"torus\", \"tube_radius\": 2}}]}", "1: objects[0].shape.tube_radius is not smaller than ring_radius"},
      {shape + "\"cube\"}, \"transforms\": [{\"rotate\": 3, \"about\": [0, 0, 0]}]}]}", "1: objects[0].transforms[0].about is no direction"},
      {shape + "\"cube\"}, \"transforms\": [{\"scale\": 3, \"translate\": [0, 0, 0]}]}]}", "1: objects[0].transforms[0] is several of translate, rotate, scale or matrix"},
      {shape + "\"cube\"}, \"transforms\": [{\"matrix\": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,1,1]]}]}]}",
       "1: objects[0].transforms[0].matrix is not 4 rows of which the last is 0, 0, 0, 1"},
  });
}

TEST_CASE("scene file: of several mistakes the first in the text is told", "[scene][scene_file][refused]") {
  check_refused_scenes({{"{\"objects\": [{}],\n\"lights\": [{}],\n\"title\": 3}", "1: objects[0].shape is missing"},
                        {"{\"unknown\": 1,\n\"title\": 3}", "1: unknown is no key that belongs here; there could be title, caption, source, image, trace, camera, ambient, lights, "
                                                            "textures, materials, environment or objects"}});
}

TEST_CASE("scene file: a file that cannot be read is refused", "[scene][scene_file][refused]") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::filesystem::path& path, const std::string& words) {
    const auto scene = read_scene(path);
    REQUIRE(!scene.ok());
    CAPTURE(scene.error().message);
    CHECK(one_line_naming(scene.error().message, words));
  };
  refused(folder / "missing.json", "no such file");
  refused(folder.write("empty.json", ""), "the file is empty");
  refused(folder.write("b\nad.json", "{\"a\": 1}"), "b?ad.json:1: a is no key");
}

TEST_CASE("scene file: what only rays can meet is refused where it is none", "[scene][scene_file][refused]") {
  const auto shape = [](const std::string& words) { return "{\"objects\": [{\"shape\": {\"type\": " + words + "}}]}"; };
  check_refused_scenes({
      {shape(R"("polygon", "outline": [[0,0,0],[1,0,0]])"), "1: objects[0].shape.outline is of fewer than 3 corners"},
      {shape(R"("polygon", "outline": [[0,0,0],[1,0,0],[0,1,0]], "holes": [{"points": [[0,0,0]]}])"), "1: objects[0].shape.holes[0].points is of fewer than 3 corners"},
      {shape(R"("polyhedron", "planes": [])"), "1: objects[0].shape.planes is empty"},
      {shape(R"("polyhedron", "planes": [[0,0,0,1]])"), "1: objects[0].shape.planes has a normal that is no direction"},
      {shape(R"("quadric", "q": [[1,0,0,0],[0,1,0,0],[0,0,1,0]])"), "1: objects[0].shape.q is not of 4 rows"},
      {shape(R"("quadric", "q": [[1,2,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,-1]])"), "1: objects[0].shape.q is not symmetric"},
      {shape(R"("quadric", "q": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,-1]], "lower": [0,0,0], "upper": [1,0,1])"), "1: objects[0].shape.upper is not above lower"},
      {R"({"trace": {"samples": 5}})", "1: trace.samples is no square number"},
      {R"({"materials": {"glass": {"shadow_density": 1}}})",
       "1: materials.glass.shadow_density is no key that belongs here; there could be model, diffuse, ambient, specular, exponent, transmission, texture, pattern, mapping, bump, "
       "mirror, alpha or two_sided"},
  });
}

TEST_CASE("scene file: how rays make the picture", "[scene][scene_file]") {
  const auto scene = scene_from_json(R"({"trace": {"depth": 12, "samples": 16, "pattern": "jittered", "seed": 9, "adaptive": true, "filter": "gaussian"},
    "materials": {"glass": {"model": "lambert", "transmission": 0.99, "refractive_index": 1.3, "shadow_density": 0.5}}})", "scene.json");
  REQUIRE(scene.ok());
  using description::Sampling;
  CHECK(scene->tracing == description::Tracing{.depth = 12, .sampling = {.pattern = Sampling::Pattern::jittered, .per_pixel = 16, .adaptive = true,
                                                                         .filter = Sampling::Filter::gaussian, .seed = 9}});
  const description::Material& glass = scene->materials.at(0);
  CHECK(glass.transmission == glm::vec3(0.99f));
  CHECK(glass.refractive_index == glm::vec3(1.3f));
  CHECK(glass.shadow_density == 0.5);
}

}  // namespace tuberia
