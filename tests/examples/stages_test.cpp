// tuberia stages and render --view, as a person and as a program meet them.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <nlohmann/json.hpp>
#include <vector>

#include "image/read_image.hpp"
#include "tests/examples/run_program.hpp"

namespace tuberia {
namespace {

using test::run_program;

bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

/// Names of elements that are never closed.
bool is_void_element(const std::string& name) { return name == "meta" || name == "img" || name == "br" || name == "hr" || name == "link"; }

/// The first end tag that does not close what was opened last, or what is left open; "" if all is well.
std::string unbalanced_element(const std::string& page) {
  std::vector<std::string> open;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
    if (page[at + 1] == '!') continue;
    const bool closes = page[at + 1] == '/';
    std::string name;
    for (std::size_t i = at + (closes ? 2 : 1); i < page.size() && std::isalnum(static_cast<unsigned char>(page[i])) != 0; ++i) name += page[i];
    if (closes) {
      if (open.empty() || open.back() != name) return name;
      open.pop_back();
    } else if (!is_void_element(name)) {
      open.push_back(name);
    }
    if (!closes && (name == "script" || name == "style")) at = page.find("</" + name, at) - 1;  // text, not tags
  }
  return open.empty() ? "" : open.back();
}

nlohmann::json embedded_data(const std::string& page) {
  const std::string mark = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = page.find(mark) + mark.size();
  return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

}  // namespace

TEST_CASE("tuberia stages: refuses what the frame does not have, naming it", "[examples]") {
  const TemporaryFolder folder;
  struct Refused {
    const char *arguments, *culprit;
  };
  for (const Refused& each : {Refused{"stages --demo layers --primitive 10", "--primitive 10: the frame has primitives 0 to 9"},
                              {"stages --demo layers --primitive -1", "--primitive -1"},
                              {"stages --demo layers --draw 1 --primitive 2", "the draw has primitives 0 to 1"},
                              {"stages --demo layers --draw 5", "--draw 5: the frame has draws 0 to 4"},
                              {"stages --demo layers --pixel 72,0", "--pixel 72,0 lies outside the target of 72x48 pixels"},
                              {"stages --demo layers --pixel 7x3", "7x3"},
                              {"stages --demo sphere", "sphere"},
                              {"stages --demo layers missing.obj", "--demo"},
                              {"stages", "--demo"},
                              {"stages missing.obj", "missing.obj"},
                              {"stages --demo layers --html none/page.html", "none"}}) {
    const test::Outcome outcome = run_program(each.arguments, folder);
    INFO(each.arguments << " says: " << outcome.output);
    CHECK(outcome.status == 2);
    CHECK(says(outcome.output, each.culprit));
  }
}

TEST_CASE("tuberia stages: tells the life of a clipped triangle", "[examples]") {
  const TemporaryFolder folder;
  const test::Outcome outcome = run_program("stages --demo clipped --primitive 0", folder);
  INFO(outcome.output);
  CHECK(outcome.status == 0);
  for (const char* words : {"object (-1.5, -0.8, 0)", "behind the eye (w <= 0)", "c2 new", "ndc (", "screen units (", "twice the area", "a left edge",
                            "# reached the target", "screen weights", "stored 16777215", "codes"})
    CHECK(says(outcome.output, words));

  const auto all = nlohmann::json::parse(run_program("stages --demo clipped --primitive 0 --json", folder).output);
  const auto& life = all.at("primitive");
  CHECK(life.at("vertices").size() == 3);
  CHECK(life.at("corners").size() == 4);
  for (const auto& corner : life.at("corners"))
    if (corner.at("made_by_clipping").get<bool>()) CHECK(corner.at("clip")[2] == -corner.at("clip")[3].get<double>());  // the near plane
  const auto& fates = life.at("fates");
  CHECK(life.at("fragments_in_window").size() == fates.at("covered").get<std::size_t>());
  CHECK(fates.at("covered") == fates.at("reached"));
}

TEST_CASE("tuberia stages: tells a pixel's history, and why fragments died", "[examples]") {
  const TemporaryFolder folder;
  const test::Outcome outcome = run_program("stages --demo layers --pixel 36,24", folder);
  INFO(outcome.output);
  CHECK(outcome.status == 0);
  CHECK(says(outcome.output, "5 fragments of 5 draws"));
  CHECK(says(outcome.output, "died at fragment shading: the program 'textured_lit_cut_out' discarded it"));
  CHECK(says(outcome.output, "died at depth test: code"));

  const auto all = nlohmann::json::parse(run_program("stages --demo layers --pixel 36,24 --json", folder).output);
  CHECK(!all.contains("primitive"));
  const auto& fragments = all.at("pixel").at("fragments");
  REQUIRE(fragments.size() == 5);
  const bool lived[5] = {true, true, false, false, true};
  nlohmann::json now = all.at("pixel").at("cleared_to")[0];
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(fragments[i].at("draw") == i);
    CHECK(fragments[i].at("lived") == lived[i]);
    CHECK(fragments[i].at("samples")[0].at("before") == now);
    now = fragments[i].at("samples")[0].at("after");
  }
  CHECK(fragments[2].at("samples")[0].at("died_at") == "fragment shading");
  CHECK(fragments[3].at("samples")[0].at("died_at") == "depth test");

  // What it ends with is what the picture shows.
  const test::Outcome again = run_program("stages --demo layers --pixel 0,0 --json", folder);
  CHECK(nlohmann::json::parse(again.output).at("pixel").at("fragments").empty());
}

TEST_CASE("tuberia stages: the page is whole, closed and needs nothing else", "[examples]") {
  const TemporaryFolder folder;
  std::ofstream(folder / "a<b.obj") << "v -1 -1 0\nv 1 -1 0\nv 0 1 0\no </script>\nf 1 2 3\n";
  for (const char* subject : {"--demo clipped --pixel 36,24", "--demo layers", "'a<b.obj' --size 300x200"}) {
    const test::Outcome outcome = run_program("stages " + std::string(subject) + " --html page.html", folder);
    INFO(subject << ": " << outcome.output);
    REQUIRE(outcome.status == 0);
    const std::string page = test::content_of(folder / "page.html");
    CHECK(unbalanced_element(page).empty());
    for (const char* panel : {"view", "clip", "ndc", "coverage", "weights", "depth", "colour", "pixel", "frame"})
      CHECK(says(page, "id=\"panel-" + std::string(panel) + "\""));
    for (const char* outside : {"http:", "https:", "//www", "@import", "url(", "src=", "href="}) CHECK(!says(page, outside));

    const nlohmann::json data = embedded_data(page);
    CHECK(data.at("primitive").at("fragments_in_window").size() > 10);
    CHECK(data.at("pixel").is_null() == (std::string(subject).find("--pixel") == std::string::npos));
    CHECK(data.at("scene").at("frustum_world").size() == 8);
    REQUIRE(data.at("maps").size() == 5);
    for (const auto& map : data.at("maps")) CHECK(map.at("picture").get<std::string>().rfind("data:image/png;base64,iVBOR", 0) == 0);
  }
}

TEST_CASE("tuberia render --view: every view is a picture with a legend", "[examples]") {
  const TemporaryFolder folder;
  // Two squares over each other, of two triangles each, with normals and texture coordinates.
  std::ofstream(folder / "squares.obj") << "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
                                           "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
                                           "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\nf 5/1/1 6/2/1 7/3/1\nf 5/1/1 7/3/1 8/4/1\n";
  struct Expected {
    const char *view, *legend;
  };
  for (const Expected& each : {Expected{"overdraw", "1 (dark) to 2 (light) fragments a pixel"}, {"depth", "depth in screen space"},
                               {"normals", "unit normal in world space"}, {"uv", "u 0.0"}, {"lod", "levels 0.000"},
                               {"tiles", "to 4 (light) primitives a tile"}, {"triangle-size", "pixels of screen area"}, {"wireframe", "edges"}}) {
    const test::Outcome outcome = run_program("render squares.obj -o view.png --size 200x150 --azimuth 10 --elevation 0 --view " + std::string(each.view), folder);
    INFO(each.view << ": " << outcome.output);
    REQUIRE(outcome.status == 0);
    CHECK(says(outcome.output, each.legend));
    const auto image = read_image(folder / "view.png");
    REQUIRE(image.ok());
    const auto differs = [&](const Rgba8& pixel) { return pixel != image->at(0, 0); };
    CHECK(std::count_if(image->pixels().begin(), image->pixels().end(), differs) > 200);
    std::filesystem::remove(folder / "view.png");
  }
}

TEST_CASE("tuberia: what would be written by nobody is refused", "[examples]") {
  const TemporaryFolder folder;
  std::ofstream(folder / "one.obj") << "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nf 1 2 3\n";
  for (const char* words : {"render one.obj -o view.png --view depth --depth depth.pfm", "render one.obj -o view.png --view overdraw --stats",
                            "stages --demo clipped --json --html page.html"}) {
    const test::Outcome outcome = run_program(words, folder);
    INFO(words << ": " << outcome.output);
    CHECK(outcome.status == 2);
    CHECK((says(outcome.output, "goes with the model's colours") || says(outcome.output, "excludes")));
  }
  CHECK(!std::filesystem::exists(folder / "view.png"));
}

}  // namespace tuberia
