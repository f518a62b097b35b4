// tuberia trace as a person meets it.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "image/read_image.hpp"
#include "tests/examples/run_program.hpp"

namespace tuberia {
namespace {

test::Outcome trace(const std::string& arguments, const TemporaryFolder& folder) { return test::run_program("trace " + arguments, folder, TUBERIA_PROGRAM); }

/// A glass ball over a floor: rays of every kind.
void write_glass(const TemporaryFolder& folder) {
  std::ofstream(folder / "glass.json") << R"({"title": "Glass", "image": {"width": 40, "height": 30, "background": [0, 0, 1]}, "trace": {"depth": 4},
    "lights": [{"type": "directional", "towards": [0, 1, 1], "shadow": {}}],
    "materials": {"red": {"diffuse": [1, 0, 0]}, "glass": {"diffuse": 0, "specular": 0.5, "mirror": 0.1, "transmission": 0.9}},
    "objects": [{"name": "floor", "shape": {"type": "plane", "width": 8, "depth": 8}, "material": "red", "transforms": [{"translate": [0, -1, 0]}]},
                {"name": "a \"ball\"", "shape": {"type": "sphere"}, "material": "glass"}]})";
}

}  // namespace

TEST_CASE("tuberia trace: refuses bad input in one line and leaves no file", "[examples][bad-input]") {
  const TemporaryFolder folder;
  write_glass(folder);
  folder.write("bad.json", "{\"trace\": {\n\"depth\": -3}}");
  struct Refused {
    const char *arguments, *culprit;
  };
  for (const Refused& each : {Refused{"", "scene is required"},
                              {"missing.json -o out.png", "missing.json"},
                              {"bad.json -o out.png", "bad.json:2: trace.depth is -3"},
                              {"ball.obj -o out.png", "'ball.obj' is no scene"},
                              {"glass.json", "--output or --tree"},
                              {"glass.json -o out.xyz", "out.xyz"},
                              {"glass.json -o none/out.png", "none"},
                              {"glass.json -o out.png --depth 1001", "--depth"},
                              {"glass.json -o out.png --depth -1", "--depth"},
                              {"glass.json -o out.png --samples 5", "--samples is 5, but must be a square number"},
                              {"glass.json -o out.png --samples 0", "--samples"},
                              {"glass.json -o out.png --pattern random", "random"},
                              {"glass.json -o out.png --filter sharp", "sharp"},
                              {"glass.json -o out.png --accelerator magic", "magic"},
                              {"glass.json -o out.png --surfaces round", "round"},
                              {"glass.json -o out.png --threads -1", "--threads"},
                              {"glass.json -o out.png --least-weight 2", "--least-weight"},
                              {"glass.json -o out.png --time 2", "--time"},
                              {"glass.json -o out.png --time nan", "--time"},
                              {"missing.json -o out.xyz", ".pfm"},                  // before anything is read
                              {"missing.json -o none/out.png", "no such folder"},
                              {"missing.json --pixel 1,2 --tree none/out.svg", "no such folder"},
                              {"glass.json -o out.png --size 0x5", "0x5"},
                              {"glass.json -o out.png --size 99999x5", "99999x5"},
                              {"glass.json -o out.png --size large", "large"},
                              {"glass.json -o out.png --colour", "--colour"},
                              {"glass.json --tree out.svg", "--pixel"},
                              {"glass.json --pixel 1,2 -o out.png", "--tree"},
                              {"glass.json --pixel 1 --tree out.svg", "'1' is not a pixel"},
                              {"glass.json --pixel 1,2,3 --tree out.svg", "1,2,3"},
                              {"glass.json --pixel 40,2 --tree out.svg", "40x30"},
                              {"glass.json --pixel 1,-1 --tree out.svg", "1,-1"},
                              {"glass.json --pixel 1,2 --tree out.png", "out.png"}}) {
    const test::Outcome outcome = trace(each.arguments, folder);
    INFO(each.arguments << " says: " << outcome.output);
    CHECK(outcome.status == 2);
    CHECK(outcome.output.find(each.culprit) != std::string::npos);
    for (const char* file : {"out.png", "out.svg", "out.xyz"}) CHECK(!std::filesystem::exists(folder / file));
  }
}

TEST_CASE("tuberia trace: the same picture on any number of threads, by any accelerator", "[examples][A40]") {
  const TemporaryFolder folder;
  write_glass(folder);
  const test::Outcome one = trace("glass.json -o one.png --threads 1 --stats", folder);
  INFO(one.output);
  REQUIRE(one.status == 0);
  for (const char* words : {"one.png: 40x30 pixels", "1 thread", "eye rays              1,200", "reflected rays", "shadow rays", "item tests"}) CHECK(one.output.find(words) != std::string::npos);
  const std::string picture = test::content_of(folder / "one.png");
  for (const char* other : {"--threads 3", "--accelerator none", "--accelerator grid", "--accelerator octree --threads 2", "--accelerator bounding-spheres"}) {
    REQUIRE(trace(std::string("glass.json -o other.png ") + other, folder).status == 0);
    CHECK(test::content_of(folder / "other.png") == picture);
  }
  for (const char* other : {"--depth 0", "--surfaces tessellated", "--samples 4", "--size 50x30", "--samples 4 --pattern jittered"}) {
    REQUIRE(trace(std::string("glass.json -o other.png ") + other, folder).status == 0);
    CHECK(test::content_of(folder / "other.png") != picture);
  }
  REQUIRE(trace("glass.json -o light.pfm --samples 9 --adaptive --filter gaussian", folder).status == 0);
  CHECK(read_float_image(folder / "light.pfm")->width() == 40);
}

TEST_CASE("tuberia trace: textures know where the camera is at that time", "[examples][A44]") {
  const TemporaryFolder folder;
  std::ofstream(folder / "floor.json") << R"({"image": {"width": 48, "height": 36}, "ambient": 1,
    "camera": {"eye": [0, 2, 9], "look_at": [0, 0, 0], "motions": [{"type": "dolly", "distance": 6}]},
    "textures": {"squares": {"source": "checker", "squares": 64, "level_rule": "distance", "texel_distance": 2}},
    "materials": {"tiles": {"texture": "squares"}}, "objects": [{"shape": {"type": "plane", "width": 20, "depth": 20}, "material": "tiles"}]})";
  for (const char* time : {"0", "1"}) {
    REQUIRE(trace(std::string("floor.json -o traced.png --surfaces tessellated --time ") + time, folder).status == 0);
    REQUIRE(test::run_program(std::string("render floor.json -o drawn.png --time ") + time, folder, TUBERIA_PROGRAM).status == 0);
    const auto traced = read_image(folder / "traced.png"), drawn = read_image(folder / "drawn.png");
    REQUIRE(traced);
    REQUIRE(drawn);
    int different = 0;
    for (std::size_t i = 0; i < drawn->pixels().size(); ++i) different += std::abs(traced->pixels()[i].r - drawn->pixels()[i].r) > 3;
    INFO("at time " << time);
    CHECK(different < 20);
  }
}

TEST_CASE("tuberia trace: writes the tree of a pixel's rays", "[examples][B55]") {
  const TemporaryFolder folder;
  write_glass(folder);
  REQUIRE(trace("glass.json --pixel 20,15 --tree tree.svg", folder).status == 0);
  REQUIRE(trace("glass.json --pixel 20,15 --tree tree.dot", folder).status == 0);
  REQUIRE(trace("glass.json --pixel 20,15 --tree tree.json --depth 2", folder).status == 0);
  CHECK(test::content_of(folder / "tree.svg").find("<svg ") == 0);
  CHECK(test::content_of(folder / "tree.dot").find("digraph") == 0);

  const nlohmann::json tree = nlohmann::json::parse(test::content_of(folder / "tree.json"));
  CHECK(tree["rays"][0]["kind"] == "eye");
  CHECK(tree["rays"][0]["object"] == "a \"ball\"");
  int deepest = 0, unfollowed = 0;
  for (const auto& ray : tree["rays"]) {
    const bool is_unfollowed = ray["end"] == "not followed: level limit";
    unfollowed += is_unfollowed;
    if (!is_unfollowed) deepest = std::max(deepest, ray["level"].get<int>());
  }
  CHECK(deepest == 2);
  CHECK(unfollowed > 0);
}

}  // namespace tuberia
