// The tree of one pixel's rays, and the files that show it.

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "reference/ray_tracer/viewing.hpp"
#include "scene/content/scene_camera.hpp"
#include "tests/image/temporary_folder.hpp"
#include "tests/ray_tracer/whitted_scenes.hpp"

namespace tuberia::tracer {
namespace {

TracedScene scene_of_figure() {
  auto description = read_scene("examples/scenes/61_ray_tree.json");
  if (!description) FAIL(description.error().message);
  return whitted_scene(*std::move(description));
}

WhittedRay middle_of_figure(const TracedScene& scene, const TraceSettings& settings) {
  const description::Picture& picture = scene.description().picture;
  const View view = *View::create(*camera_of(scene.description().camera, 1), picture.width, picture.height);
  return whitted_ray(scene, view.ray(0.5 * glm::dvec2(picture.width, picture.height)), settings);
}

/// The rays that were followed, but for shadow rays: parent's name and object that was met.
std::map<std::string, std::pair<std::string, std::string>> followed(const RayTree& tree) {
  std::map<std::string, std::pair<std::string, std::string>> rays;
  for (const TracedRay& ray : tree.rays())
    if (ray.kind != RayKind::shadow && ray.was_followed())
      rays[ray.name] = {ray.parent < 0 ? "" : tree.rays()[static_cast<std::size_t>(ray.parent)].name, ray.object};
  return rays;
}

std::set<std::string> names_of(const RayTree& tree) {
  std::set<std::string> names;
  for (const auto& ray : followed(tree)) names.insert(ray.first);
  return names;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

RayTree badly_named_tree() {
  RayTree tree;
  const int eye = tree.add(RayKind::eye, -1, 0, glm::dvec3(1), {});
  tree.meet(eye, "a \"b\" \\ <c> & \n\x01 d", 1.5, {1, 2, 3});
  tree.end(eye, RayEnd::branched, glm::dvec3(kInfinity, 0, 0.5));
  const int child = tree.add(RayKind::reflected, eye, 1, glm::dvec3(0.5), {});
  tree.end(child, RayEnd::level, glm::dvec3(0));
  return tree;
}

}  // namespace

TEST_CASE("ray tree: one pixel meets the surfaces of the notes' figures in their order", "[ray_tracer][B53][B55][A45]") {
  const TracedScene scene = scene_of_figure();
  using Rays = std::map<std::string, std::pair<std::string, std::string>>;
  const Rays expected{{"E", {"", "S1"}},   {"R1", {"E", "S2"}}, {"T1", {"E", ""}},  {"R2", {"R1", "S3"}},
                      {"T2", {"R1", "S4"}}, {"R3", {"R2", ""}},  {"T3", {"R2", ""}}, {"R4", {"T2", ""}}};
  const WhittedRay whole = middle_of_figure(scene, {});
  CHECK(followed(whole.tree) == expected);
  CHECK(whole.scratch.reflected_rays == 4);
  CHECK(whole.scratch.transmitted_rays == 3);

  // Levels, and the products of the coefficients along the branches.
  struct Branch {
    const char* name;
    int level;
    double weight;
  };
  for (const Branch& branch : {Branch{"E", 0, 1}, {"R1", 1, .5}, {"T1", 1, .4}, {"R2", 2, .25}, {"T2", 2, .25}, {"R3", 3, .125}, {"T3", 3, .05}, {"R4", 3, .125}}) {
    CAPTURE(branch.name);
    CHECK(whitted_named(whole.tree, branch.name)->level == branch.level);
    CHECK(whitted_named(whole.tree, branch.name)->weight.x == Approx(branch.weight));
  }
  for (const char* name : {"T1", "R3", "T3", "R4"}) CHECK(whitted_named(whole.tree, name)->end == RayEnd::escaped);
}

TEST_CASE("ray tree: depth 2 drops T3, R3 and R4; the threshold drops T3", "[ray_tracer][B53][B55]") {
  const TracedScene scene = scene_of_figure();
  const WhittedRay shallow = middle_of_figure(scene, {.most_level = 2});
  CHECK(names_of(shallow.tree) == std::set<std::string>{"E", "R1", "T1", "R2", "T2"});
  for (const char* name : {"T3", "R3", "R4"}) CHECK(whitted_named(shallow.tree, name)->end == RayEnd::level);

  const WhittedRay adaptive = middle_of_figure(scene, {.least_weight = 0.1});
  CHECK(names_of(adaptive.tree) == std::set<std::string>{"E", "R1", "T1", "R2", "T2", "R3", "R4"});
  CHECK(whitted_named(adaptive.tree, "T3")->end == RayEnd::weight);
  CHECK(whitted_named(adaptive.tree, "T3")->light == glm::dvec3(0));

  // What each drops is missing from the pixel.
  const WhittedRay whole = middle_of_figure(scene, {});
  const auto part = [&](const char* name) { return whitted_named(whole.tree, name)->weight * whitted_named(whole.tree, name)->light; };
  CHECK(whitted_is_near(whole.light - adaptive.light, part("T3")));
  CHECK(whitted_is_near(whole.light - shallow.light, part("T3") + part("R3") + part("R4")));
  CHECK(part("T3").x == Approx(0.05 * 0.2));
}

TEST_CASE("ray tree: every file names each ray, who it comes from and why it stopped", "[ray_tracer][B55]") {
  const RayTree tree = middle_of_figure(scene_of_figure(), {.most_level = 2}).tree;
  const std::size_t count = tree.rays().size();
  const std::string dot = dot_of(tree), json = json_of(tree), svg = svg_of(tree);
  CHECK(count_of(dot, " -> ") == count - 1);
  CHECK(count_of(json, "\"parent\": ") == count);
  CHECK(count_of(svg, "<rect ") == count);
  CHECK(count_of(svg, "<path ") == count - 1);
  for (const std::string& text : {dot, json, svg}) {
    CHECK(count_of(text, "level limit") == 3);
    CHECK(text.find("S4") != std::string::npos);
  }
  CHECK(json.find(R"("name": "T3", "kind": "transmitted")") != std::string::npos);
}

TEST_CASE("ray tree: whatever objects are called, the files are well-formed", "[ray_tracer][bad-input]") {
  const RayTree tree = badly_named_tree();
  const std::string dot = dot_of(tree), json = json_of(tree), svg = svg_of(tree);
  CHECK(dot.find(R"(a \"b\" \\ <c> &    d)") != std::string::npos);
  CHECK(json.find(R"("a \"b\" \\ <c> & \u000a\u0001 d")") != std::string::npos);
  CHECK(json.find("\"light\": [null, 0, 0.5]") != std::string::npos);
  CHECK(svg.find("a &quot;b&quot; \\ &lt;c&gt; &amp;") != std::string::npos);
  // A scene's reader is as good a judge of JSON as any: this is one, of keys that it does not know.
  const auto judged = scene_from_json(json, "tree");
  CHECK(judged.error().message.find("rays") != std::string::npos);

  CHECK(dot_of(RayTree{}).find("digraph") == 0);
  CHECK(svg_of(RayTree{}).find("</svg>") != std::string::npos);
}

TEST_CASE("ray tree: files are written by their extension", "[ray_tracer][bad-input]") {
  const TemporaryFolder folder;
  const RayTree tree = badly_named_tree();
  const auto content = [](const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  };
  for (const char* name : {"tree.dot", "tree.json", "tree.SVG"}) CHECK(write_ray_tree((folder / name).string(), tree).ok());
  CHECK(content(folder / "tree.dot") == dot_of(tree));
  CHECK(content(folder / "tree.json") == json_of(tree));
  CHECK(content(folder / "tree.SVG") == svg_of(tree));
  CHECK(write_ray_tree((folder / "tree.png").string(), tree).error().message.find("tree.png") != std::string::npos);
  CHECK(write_ray_tree((folder / "none" / "tree.svg").string(), tree).error().message.find("none") != std::string::npos);
}

}  // namespace tuberia::tracer
