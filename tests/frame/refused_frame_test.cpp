// Scenes that are well said but cannot be drawn.

#include <catch2/catch.hpp>

#include "tests/frame/drawn_scene.hpp"
#include "tests/image/temporary_folder.hpp"

namespace tuberia {
namespace {

void check_undrawable(const std::string& text, const std::string& words) {
  const std::string message = test::refusal_of_scene(test::scene_from(text));
  CAPTURE(text, message);
  CHECK(one_line_naming(message, words));
}

std::string with_shading(const std::string& shading, const std::string& material, const std::string& more = "") {
  return R"({"image": {"width": 8, "height": 8}, "textures": {"t": {"source": "checker"}}, "environment": {"source": "sky", "resolution": 8},
    "materials": {"m": {)" + material + R"(}}, "objects": [{"name": "ball", "shape": {"type": "sphere"}, "material": "m", "shading": ")" + shading + "\"}]" + more + "}";
}

}  // namespace

TEST_CASE("frame: what only fragments can have is refused at vertices", "[frame][refused]") {
  check_undrawable(with_shading("gouraud", R"("model": "cook-torrance")"), "object 0 'ball': this reflection model goes with shading phong only");
  check_undrawable(with_shading("flat", R"("pattern": {"type": "wood"})"), "object 0 'ball': a pattern goes with shading phong only");
  check_undrawable(with_shading("gouraud", R"("bump": {"type": "waves"})"), "object 0 'ball': a bump goes with shading phong only");
  check_undrawable(with_shading("gouraud", R"("mirror": 0.5)"), "object 0 'ball': a mirror goes with shading phong only");
  check_undrawable(with_shading("flat", R"("texture": "t")"), "object 0 'ball': a texture goes with shading phong only");
  check_undrawable(with_shading("gouraud", "", R"(, "lights": [{"type": "directional", "shadow": {}}])"), "object 0 'ball': a light with shadow or projection goes with");
  check_undrawable(with_shading("gouraud", "", R"(, "lights": [{"type": "area", "samples": 3}])"), "object 0 'ball': more than 4 lights");
  check_undrawable(with_shading("dot-product", "", R"(, "lights": [{"type": "area", "samples": 2}])"), "object 0 'ball': more than 2 lights");
  CHECK(test::refusal_of_scene(test::scene_from(with_shading("gouraud", R"("texture": "t")"))).empty());
}

TEST_CASE("frame: files that are not there are refused with their names", "[frame][refused]") {
  check_undrawable(R"({"textures": {"wall": {"file": "no such wall.png"}}, "materials": {"m": {"texture": "wall"}}, "objects": [{"shape": {"type": "cube"}, "material": "m"}]})",
                   "texture 'wall': ");
  check_undrawable(R"({"objects": [{"shape": {"type": "model", "file": "no such model.obj"}}]})", "object 0: ");
  check_undrawable(R"({"environment": {"source": "panorama", "file": "no such hall.hdr"}})", "environment: ");
  check_undrawable(R"({"environment": {"source": "faces", "faces": {"+x": "a.png", "-x": "a.png", "+y": "a.png", "-y": "a.png", "+z": "a.png", "-z": "a.png"}}})", "environment: ");
}

TEST_CASE("frame: a projection that stands on its head is refused", "[frame][refused]") {
  check_undrawable(R"({"textures": {"t": {"source": "checker"}}, "objects": [{"shape": {"type": "plane"}}],
    "lights": [{"type": "spot", "name": "slides", "position": [0, 5, 0], "projection": {"texture": "t"}}]})", "light 0 'slides': its projection: ");
}

TEST_CASE("frame: scenes that no file could say are refused, too", "[frame][refused]") {
  SceneDescription scene;
  scene.camera.up = {0, 0, 1};  // along the line of sight
  CHECK(one_line_naming(test::refusal_of_scene(scene), "camera: "));
  scene = {};
  scene.objects.emplace_back();
  scene.objects[0].name = "ball";
  scene.objects[0].material = "red";
  CHECK(one_line_naming(test::refusal_of_scene(scene), "object 0 'ball': there is no material 'red'"));
  scene.objects[0].material = "";
  scene.picture.width = 20000;
  CHECK_FALSE(test::refusal_of_scene(scene).empty());
  scene.picture.width = scene.picture.height = 8;
  CHECK(test::refusal_of_scene(scene).empty());
}

TEST_CASE("frame: relief needs texture coordinates", "[frame][refused]") {
  check_undrawable(R"({"materials": {"m": {"bump": {"type": "waves"}}}, "objects": [{"material": "m",
    "shape": {"type": "mesh", "positions": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,2]]}}]})", "object 0: ");
}

TEST_CASE("frame: what only rays can meet is refused with its name", "[frame][refused]") {
  const auto check = [](const std::string& shape, const std::string& what) {
    check_undrawable(R"({"objects": [{"name": "it", "shape": {"type": )" + shape + "}}]}", "object 0 'it': " + what + " can only be traced (tuberia trace)");
  };
  check(R"("infinite-plane")", "an infinite plane");
  check(R"("polygon", "outline": [[0,0,0],[3,0,0],[0,3,0]], "holes": [{"points": [[0.5,0.5,0],[1,0.5,0],[0.5,1,0]]}])", "a polygon with holes");
  check(R"("polygon", "outline": [[0,0,0],[3,0,0],[0.5,0.5,0],[0,3,0]])", "a polygon that is not convex");
  check(R"("polygon", "outline": [[0,1,0],[-0.6,-0.8,0],[0.95,0.3,0],[-0.95,0.3,0],[0.6,-0.8,0]])", "a polygon that is not convex");  // a pentagram: turns twice round
  check(R"("polyhedron", "planes": [[0,1,0,0]])", "a polyhedron of planes");
  check(R"("quadric", "q": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,-1]])", "a quadric");
}

TEST_CASE("frame: a convex polygon is drawn", "[frame]") {
  const test::DrawnScene drawn = test::drawn(R"({"image": {"width": 32, "height": 32}, "ambient": 1, "materials": {"m": {"diffuse": 0.25}},
    "objects": [{"material": "m", "shape": {"type": "polygon", "outline": [[-1,-1,0],[1,-1,0],[1,1,0],[0,1.5,0],[-1,1,0]]}}]})");
  CHECK(drawn.at({0.9, 0.9, 0}).r == 0.25f);
  CHECK(drawn.at({0, 1.4, 0}).r == 0.25f);
  CHECK(drawn.at({0.9, 1.4, 0}).r == 0);
}

TEST_CASE("frame: what is clear lets through its share of what lies behind, and warns", "[frame]") {
  // A pane of one side, and a slab of two, in front of a wall; ambient light alone: I = ka + kt behind at each side.
  const auto scene_with = [](const std::string& shape) {
    return test::drawn(R"({"image": {"width": 32, "height": 32}, "ambient": 1, "materials": {"wall": {"diffuse": 0.5}, "glass": {"diffuse": 0.125, "transmission": [0.5, 0.25, 1]}},
      "objects": [{"shape": {"type": "cube", "size": [9, 9, 1]}, "material": "wall", "transforms": [{"translate": [0, 0, -3]}]},
                  {"name": "pane", "shape": )" + shape + R"(, "material": "glass"}]})");
  };
  const test::DrawnScene pane = scene_with(R"({"type": "polygon", "outline": [[-1,-1,0],[1,-1,0],[1,1,0],[-1,1,0]]})");
  CHECK(pane.at({0, 0, 0}) == Rgba32F{0.375f, 0.25f, 0.625f, 1});
  REQUIRE(pane.warnings.size() == 1);
  CHECK(one_line_naming(pane.warnings[0], "object 1 'pane'"));
  const test::DrawnScene slab = scene_with(R"({"type": "cube", "size": [1, 1, 0.1]})");
  CHECK(slab.at({0, 0, 0}) == Rgba32F{0.3125f, 0.1875f, 0.75f, 1});
}

TEST_CASE("frame: a mirror without surroundings is drawn without, and warned of", "[frame]") {
  const auto scene_with = [](const std::string& more) {
    return test::drawn(R"({"image": {"width": 8, "height": 8}, "ambient": 1, "materials": {"m": {"diffuse": 0.25, "mirror": 0.5}},
      "objects": [{"name": "ball", "shape": {"type": "sphere"}, "material": "m"}])" + more + "}");
  };
  const test::DrawnScene lonely = scene_with("");
  CHECK(lonely.at({0, 0, 1}).r == 0.25f);
  REQUIRE(lonely.warnings.size() == 1);
  CHECK(one_line_naming(lonely.warnings[0], "object 0 'ball'"));
  CHECK(scene_with(R"(, "environment": {"source": "sky", "resolution": 8})").warnings.empty());
}

TEST_CASE("frame: colours at vertices that no program reads are warned of", "[frame]") {
  const auto scene_with = [](const std::string& shading) {
    return test::drawn(R"({"image": {"width": 8, "height": 8}, "objects": [{"name": "leaf", "shading": ")" + shading + R"(",
      "shape": {"type": "mesh", "positions": [[0,0,0],[1,0,0],[0,1,0]], "colours": [[1,0,0],[1,0,0],[1,0,0]], "triangles": [[0,1,2]]}}]})");
  };
  CHECK(scene_with("gouraud").warnings.empty());
  REQUIRE(scene_with("phong").warnings.size() == 1);
  CHECK(one_line_naming(scene_with("phong").warnings[0], "object 0 'leaf'"));
}

TEST_CASE("frame: an empty scene is its background", "[frame][bad]") {
  const test::DrawnScene empty = test::drawn(R"({"image": {"width": 4, "height": 4, "background": [0.1, 0.2, 0.3]}, "lights": [{"type": "directional", "shadow": {}}]})");
  CHECK(empty.light.at(2, 2) == Rgba32F{0.1f, 0.2f, 0.3f, 1});
}

}  // namespace tuberia
