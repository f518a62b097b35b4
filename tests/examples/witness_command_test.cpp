// tuberia witness as a person meets it.

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>

#include "tests/examples/run_program.hpp"

namespace tuberia {
namespace {

constexpr const char* kBall = R"({"title": "A ball", "image": {"width": 40, "height": 30}, "lights": [{"type": "directional", "shadow": {"resolution": 64}}],
  "objects": [{"shape": {"type": "sphere"}}]})";

}  // namespace

TEST_CASE("tuberia witness: a scene is confirmed, and the page says so", "[Y5][examples]") {
  const TemporaryFolder folder;
  folder.write("ball.json", kBall);
  const auto outcome = test::run_program("witness ball.json --size 60x40 --threads 2 -o ball.html", folder);
  INFO(outcome.output);
  CHECK(outcome.status == 0);
  for (const char* word : {"A ball", "pixels", "2400", "unexplained", "  confirmed"}) CHECK(outcome.output.find(word) != std::string::npos);
  CHECK(outcome.output.find('\r') == std::string::npos);  // no terminal, no progress
  const std::string page = test::content_of(folder / "ball.html");
  CHECK(page.find("60 x 40 pixels") != std::string::npos);
  CHECK(page.find("Confirmed: the same object at 100.000 %") != std::string::npos);
}

TEST_CASE("tuberia witness: refuses bad input in one line and leaves no page", "[Y5][examples]") {
  const TemporaryFolder folder;
  folder.write("ball.json", kBall);
  folder.write("cut.json", R"({"objects": [)");
  folder.write("plane.json", R"({"objects": [{"name": "floor", "shape": {"type": "infinite-plane"}}]})");
  folder.write("nowhere.json", R"({"camera": {"eye": [0, 0, 0], "look_at": [0, 0, 0]}, "objects": [{"shape": {"type": "sphere"}}]})");
  struct Refused {
    const char *arguments, *culprit;
  };
  for (const Refused& each : {Refused{"missing.json", "missing.json"}, {"cut.json", "cut.json"}, {"plane.json", "floor"}, {"nowhere.json", "camera"}, {"ball.json --size large", "large"},
                              {"ball.json --size 0x5", "--size 0x5 must be 1 to 16384 pixels each way"}, {"ball.json --size 5x0", "--size 5x0 must be"}, {"ball.json --size 65536x4", "65536"}, {"ball.json --threads -1", "-1"}, {"", "scene"}}) {
    const auto outcome = test::run_program(std::string("witness ") + each.arguments + " -o out.html", folder);
    INFO(each.arguments << "\n" << outcome.output);
    CHECK(outcome.status == 2);
    CHECK(outcome.output.find(each.culprit) != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(folder / "out.html"));
  }
  // Before any work: the scene is not even read.
  for (const Refused& each : {Refused{"missing.json -o none/out.html", "none/out.html"}, {"missing.json -o out.png", "out.png"}, {"missing.json -o .html", ".html"}}) {
    const auto outcome = test::run_program(std::string("witness ") + each.arguments, folder);
    INFO(each.arguments << "\n" << outcome.output);
    CHECK(outcome.status == 2);
    CHECK(outcome.output.find(each.culprit) != std::string::npos);
    CHECK(outcome.output.find("missing.json") == std::string::npos);
  }
}

}  // namespace tuberia
