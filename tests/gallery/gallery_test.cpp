// The gallery's scenes, small: each has a golden picture, and each is on the page.

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "examples/tuberia/gallery/gallery.hpp"
#include "scene/description/read_scene.hpp"
#include "scene/content/develop.hpp"
#include "scene/frame/scene_frame.hpp"
#include "tests/golden/golden.hpp"
#include "tests/support/every_instruction_set.hpp"

namespace tuberia {
namespace {

const std::filesystem::path kSceneFolder = "examples/scenes";

std::set<std::string> scene_names() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kSceneFolder)) names.insert(entry.path().stem().string());
  return names;
}

std::set<std::string> names_on_the_page() {
  std::set<std::string> names;
  for (const auto& section : cli::gallery_sections())
    for (const std::string& name : section.names) CHECK(names.insert(name).second);
  return names;
}

bool is_traced(const std::string& name) {
  for (const auto& section : cli::gallery_sections())
    if (section.traced && std::find(section.names.begin(), section.names.end(), name) != section.names.end()) return true;
  return false;
}

/// A fifth of the size, one sample a pixel, and surroundings to match.
SceneDescription small_scene(const std::string& name) {
  auto scene = read_scene(kSceneFolder / (name + ".json"));
  if (!scene) FAIL(scene.error().message);
  scene->picture.width = std::max(scene->picture.width / 5, 1);
  scene->picture.height = std::max(scene->picture.height / 5, 1);
  scene->picture.supersampling = 1;
  if (scene->environment) scene->environment->resolution = 64;
  return *scene;
}

Image<Rgba8> picture_of_frame(SceneFrame& frame, const PipelineOptions& options) {
  Pipeline pipeline(options);
  const auto light = frame.draw(pipeline);
  if (!light) FAIL(light.error().message);
  return srgb_codes_of(developed(*light, frame.scene().picture));
}

bool has_more_than_one_colour(const Image<Rgba8>& image) {
  return std::any_of(image.pixels().begin(), image.pixels().end(), [&](const Rgba8& pixel) { return !(pixel == image.pixels()[0]); });
}

}  // namespace

TEST_CASE("gallery: every scene of the gallery, drawn on every instruction set and number of threads", "[gallery]") {
  test::GoldenFolders folders;
  folders.golden /= "scenes";
  for (const std::string& name : scene_names()) {
    if (is_traced(name)) continue;  // those are tests/ray_tracer's
    CAPTURE(name);
    auto frame = SceneFrame::create(small_scene(name));
    if (!frame) FAIL(frame.error().message);
    test::for_every_instruction_set([&](InstructionSet set) {
      for (const int threads : {1, 3})
        CHECK(test::golden_difference(name, picture_of_frame(*frame, {.threads = threads, .instruction_set = set}), folders) == "");
    });
  }
}

TEST_CASE("gallery: the gallery shows every scene file, and nothing that is not there", "[gallery]") {
  const std::set<std::string> files = scene_names(), shown = names_on_the_page();
  CHECK(files.size() >= 40);
  for (const std::string& name : files) CHECK(shown.contains(name));
  for (const std::string& name : shown) CHECK((files.contains(name) || cli::is_figure(name) || cli::is_model(name)));
}

TEST_CASE("gallery: every scene says what it is, what to see and where it comes from", "[gallery]") {
  for (const std::string& name : scene_names()) {
    const SceneDescription scene = small_scene(name);
    CAPTURE(name);
    CHECK_FALSE(scene.title.empty());
    CHECK(scene.caption.size() > 40);
    CHECK_FALSE(scene.source.empty());
  }
}

TEST_CASE("gallery: the figures of the gallery are drawn", "[gallery]") {
  Pipeline pipeline({.threads = 1});
  for (const std::string& name : names_on_the_page()) {
    if (!cli::is_figure(name)) continue;
    CAPTURE(name);
    const auto figure = cli::figure_drawing(name, kSceneFolder, pipeline);
    if (!figure) FAIL(figure.error().message);
    CHECK(has_more_than_one_colour(figure->image));
    CHECK_FALSE(figure->caption.empty());
  }
}

TEST_CASE("gallery: the tree of one pixel's rays is a drawing", "[gallery]") {
  Workers workers;
  const std::filesystem::path file = kSceneFolder / "61_ray_tree.json";
  CHECK(cli::is_ray_tree(file.stem().string()));
  const auto tree = cli::ray_tree_drawing(file, workers);
  if (!tree) FAIL(tree.error().message);
  CHECK(tree->svg.starts_with("<svg"));
  for (const char* name : {"E, ", "R1, ", "R2, ", "T2, "}) CHECK(tree->svg.find(name) != std::string::npos);  // figure 32
  CHECK_FALSE(cli::ray_tree_drawing("no_such_scene.json", workers));
}

TEST_CASE("gallery: the gallery's page names every picture once, and escapes what it says", "[gallery]") {
  cli::GallerySection section{.title = "Light & shade", .lede = "a < b"};
  section.pictures.push_back({.file = "one.png", .title = "\"One\"", .source = "B", .caption = "c", .performance = "1 ms", .width_pixels = 4000});
  const std::string page = cli::gallery_page({section}, "a machine");
  CHECK(page.find("Light &amp; shade") != std::string::npos);
  CHECK(page.find("a &lt; b") != std::string::npos);
  CHECK(page.find("alt=\"&quot;One&quot;\"") != std::string::npos);
  CHECK(page.find("src=\"one.png\"") == page.rfind("src=\"one.png\""));
  CHECK(page.find("width:640px") != std::string::npos);
}

}  // namespace tuberia
