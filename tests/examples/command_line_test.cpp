// The command-line renderer as a person meets it: what it says, what it leaves behind, and with
// which exit status.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "image/read_image.hpp"
#include "tests/examples/run_program.hpp"

namespace tuberia {
namespace {

using test::Outcome;

Outcome run(const std::string& arguments, const TemporaryFolder& folder, const char* program = TUBERIA_PROGRAM) {
  return test::run_program(arguments, folder, program);
}

std::string content(const std::filesystem::path& path) { return test::content_of(path); }

void write_triangle(const std::filesystem::path& path) {
  std::ofstream(path) << "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
}

void write_scene(const std::filesystem::path& path) {
  std::ofstream(path) << R"({"title": "A ball", "image": {"width": 40, "height": 30}, "lights": [{"type": "directional", "shadow": {"resolution": 64}}],
    "materials": {"red": {"diffuse": [1, 0, 0], "specular": 0.5}}, "objects": [{"shape": {"type": "sphere"}, "material": "red"}]})";
}

}  // namespace

TEST_CASE("tuberia: refuses bad input in one line and leaves no file", "[examples]") {
  const TemporaryFolder folder;
  write_triangle(folder / "triangle.obj");
  write_scene(folder / "scene.json");
  folder.write("bad.json", "{\"materials\": {\"red\": {\n\"exponent\": -3}}}");
  struct Refused {
    const char *arguments, *culprit;
  };
  for (const Refused& each : {Refused{"render missing.obj -o out.png", "missing.obj"},
                              {"render . -o out.png", "'.'"},
                              {"render triangle.obj -o out.xyz", "out.xyz"},
                              {"render triangle.obj -o none/out.png", "none"},
                              {"render triangle.obj -o out.png --size 0x5", "0x5"},
                              {"render triangle.obj -o out.png --size 65536x10", "65536x10"},
                              {"render triangle.obj -o out.png --size large", "large"},
                              {"render triangle.obj -o out.png --program sparkle", "sparkle"},
                              {"render triangle.obj -o out.png --threads -1", "-1"},
                              {"render triangle.obj -o out.png --eye 0 0 0 --look-at 0 0 0", "camera"},
                              {"render triangle.obj -o out.png --colour", "--colour"},
                              {"render triangle.obj -o out.png --view sideways", "sideways"},
                              {"render triangle.obj -o out.png --subpixel-bits 9", "--subpixel-bits"},
                              {"render triangle.obj -o out.png --perspective every-9", "every-9"},
                              {"render triangle.obj -o out.png --edges double", "double"},
                              {"render triangle.obj -o out.png --anisotropy 17", "--anisotropy"},
                              {"render triangle.obj -o out.png --filter-weights 4-bit", "4-bit"},
                              {"render triangle.obj -o out.png --footprint round", "round"},
                              {"render triangle.obj -o out.png --fog thick", "thick"},
                              {"render triangle.obj -o out.png --normals long", "long"},
                              {"render triangle.obj -o out.png --supersample 0", "--supersample"},
                              {"render triangle.obj -o out.png --supersample 2 --depth out.pfm", "--supersample"},
                              {"render triangle.obj -o out.png --supersample 2 --view depth", "--supersample"},
                              {"render triangle.obj -o out.png --precision careless", "careless"},
                              {"render triangle.obj -o out.png --program flat --precision power", "'power'"},
                              {"render triangle.obj -o out.png --fog exp --fog-density -1", "--fog-density"},
                              {"render triangle.obj", "--output"},
                              {"paint triangle.obj", "paint"},
                              {"info missing.obj", "missing.obj"},
                              {"info", "model is required"},
                              {"info missing.json", "missing.json"},
                              {"render missing.json -o out.png", "missing.json"},
                              {"render bad.json -o out.png", "bad.json:2: materials.red.exponent is -3, but must be 0 or more"},
                              {"info bad.json", "bad.json:2: materials.red.exponent"},
                              {"render scene.json -o out.png --filter nearest", "--filter goes with model files"},
                              {"render scene.json -o out.png --view depth", "--view goes with model files"},
                              {"render scene.json -o out.png --time 2", "--time"},
                              {"render scene.json -o out.xyz", "out.xyz"},
                              {"requirements scene.json", "scene.json is a scene"},
                              {"render triangle.obj -o out.png --time 0.5", "--time goes with scene files"},
                              {"compare missing.png other.png", "missing.png"}}) {
    const Outcome outcome = run(each.arguments, folder);
    INFO(each.arguments << " says: " << outcome.output);
    CHECK(outcome.status != 0);
    CHECK(outcome.status != -1);
    CHECK(outcome.output.find(each.culprit) != std::string::npos);
    CHECK(!std::filesystem::exists(folder / "out.png"));
    CHECK(!std::filesystem::exists(folder / "out.xyz"));
  }
}

TEST_CASE("tuberia: renders scenes, with progress, the same on any number of threads", "[examples][C02]") {
  const TemporaryFolder folder;
  write_scene(folder / "a ball.json");
  const Outcome one = run("render 'a ball.json' -o one.png --threads 1 --stats", folder);
  INFO(one.output);
  REQUIRE(one.status == 0);
  for (const char* words : {"shadows of light 0", "picture", "2 passes", "triangles drawn"}) CHECK(one.output.find(words) != std::string::npos);
  REQUIRE(run("render 'a ball.json' -o three.png --threads 3", folder).status == 0);
  CHECK(content(folder / "one.png") == content(folder / "three.png"));
  const auto picture = read_image(folder / "one.png");
  REQUIRE(picture.ok());
  CHECK(picture->width() == 40);
  CHECK(picture->at(20, 15).r > 200);
  CHECK(picture->at(1, 1) == Rgba8{0, 0, 0, 255});
  REQUIRE(run("render 'a ball.json' -o large.png --size 80x20 --supersample 2", folder).status == 0);
  CHECK(read_image(folder / "large.png")->width() == 80);
  REQUIRE(run("render 'a ball.json' -o light.pfm", folder).status == 0);
  CHECK(read_float_image(folder / "light.pfm")->at(20, 15).r > 1);  // its highlight is more than a screen shows
}

TEST_CASE("tuberia: tells what a scene holds, and what a scene may hold", "[examples][C02]") {
  const TemporaryFolder folder;
  write_scene(folder / "ball.json");
  const Outcome info = run("info ball.json", folder);
  CHECK(info.status == 0);
  for (const char* words : {"A ball", "40x30", "directional, casts shadows", "material  'red'", "sphere, Phong shading, material 'red'"}) CHECK(info.output.find(words) != std::string::npos);
  CHECK(run("info --scene-keys", folder).output == content("docs/scene_file.md"));
}

TEST_CASE("tuberia: renders a file whose name has spaces and compares pictures", "[examples]") {
  const TemporaryFolder folder;
  write_triangle(folder / "one triangle.obj");
  REQUIRE(run("render 'one triangle.obj' -o 'a picture.png' --size 64x48 --depth depth.pfm --stats", folder).status == 0);
  REQUIRE(run("render 'one triangle.obj' -o b.png --size 64x48 --threads 7", folder).status == 0);
  REQUIRE(run("render 'one triangle.obj' -o c.png --size 64x48 --azimuth 70", folder).status == 0);
  CHECK(read_image(folder / "a picture.png")->width() == 64);
  CHECK(std::filesystem::exists(folder / "depth.pfm"));

  const Outcome same = run("compare 'a picture.png' b.png", folder);
  CHECK(same.status == 0);
  CHECK(same.output.find("equal") == 0);
  const Outcome other = run("compare b.png c.png --diff difference.png", folder);
  CHECK(other.status == 1);
  CHECK(other.output.find("different") == 0);
  CHECK(std::filesystem::exists(folder / "difference.png"));
}

TEST_CASE("tuberia: the bunny has the same bits for all threads and instruction sets", "[examples][exact]") {
  const std::string bunny = "/usr/share/glmark2/models/bunny.obj";
  if (!std::filesystem::exists(bunny)) return;
  const TemporaryFolder folder;
  std::string first;
  for (const char* threads : {"1", "2", "7"})
    for (const char* isa : {"sse4", "neon", "avx2", "avx3"}) {
      const Outcome outcome = run("render " + bunny + " -o out.png --size 960x540 --frames 1 --threads " + threads + " --isa " + isa, folder);
      if (outcome.output.find("this machine does not run") != std::string::npos) continue;
      INFO(threads << " threads, " << isa << ": " << outcome.output);
      REQUIRE(outcome.status == 0);
      const std::string picture = content(folder / "out.png");
      if (first.empty()) first = picture;
      CHECK(picture == first);
    }
  CHECK(!first.empty());
}

TEST_CASE("tuberia requirements: tells what a model needs, in words and as JSON", "[examples]") {
  const TemporaryFolder folder;
  write_triangle(folder / "triangle.obj");
  const Outcome words = run("requirements triangle.obj", folder);
  INFO(words.output);
  CHECK(words.status == 0);
  for (const char* part : {"draw 0: 1 triangles, program phong", "not needed", "All vertices lie between the near and far plane", "position, normal"})
    CHECK(words.output.find(part) != std::string::npos);

  // Of five squares one is translucent and one has holes.
  const Outcome json = run("requirements --demo layers --json", folder);
  REQUIRE(json.status == 0);
  const auto draws = nlohmann::json::parse(json.output)["draws"];
  REQUIRE(draws.size() == 5);
  int blended = 0, late = 0;
  for (const auto& draw : draws)
    for (const auto& feature : draw["features"]) {
      blended += feature["feature"] == "blending" && feature["needed"] ? 1 : 0;
      late += feature["feature"] == "late depth test" && feature["needed"] ? 1 : 0;
    }
  CHECK(blended == 1);
  CHECK(late == 1);
  CHECK(run("requirements", folder).status != 0);
}

}  // namespace tuberia
