// Clear bodies that do not bend light look the same drawn and traced: the pipeline's I = local + kt behind is then no approximation.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "reference/ray_tracer/ray_tracer.hpp"
#include "reference/ray_tracer/viewing.hpp"
#include "scene/content/scene_camera.hpp"
#include "scene/description/read_scene.hpp"
#include "scene/frame/scene_frame.hpp"

namespace tuberia::witness {
namespace {

/// A ball, a box and a pane of an index that is filled in, a film of alpha, in front of a bar.
std::string clear_scene(const std::string& index) {
  const std::string bends = "\"refractive_index\": " + index;
  return std::string(R"({"image": {"width": 150, "height": 100, "background": [0.1, 0.2, 0.4]}, "ambient": 0.3, "camera": {"eye": [0, 1, 6], "look_at": [0, 0, 0]},
    "lights": [{"type": "point", "position": [3, 5, 4]}],
    "materials": {"bar": {"diffuse": [0.9, 0.5, 0.3]}, "film": {"diffuse": [0.9, 0.2, 0.2], "alpha": 0.4},
      "glass": {"diffuse": [0.1, 0.1, 0.2], "specular": 0.5, "transmission": [0.8, 0.9, 0.7], )").append(bends)
      .append(R"(}, "pane": {"diffuse": [0.1, 0.3, 0.1], "transmission": [0.5, 0.9, 0.5], )").append(bends).append(R"(}},
    "objects": [{"shape": {"type": "cube", "size": [9, 1, 0.5]}, "material": "bar", "transforms": [{"translate": [0, 0, -2]}]},
      {"shape": {"type": "sphere"}, "material": "glass", "transforms": [{"translate": [-1.2, 0, 0]}]},
      {"shape": {"type": "polygon", "outline": [[0,-1,0],[1,-1,0],[1,1,0],[0.5,1.5,0],[0,1,0]]}, "material": "pane"},
      {"shape": {"type": "polygon", "outline": [[1.2,-1,0],[2,-1,0],[2,1,0],[1.2,1,0]]}, "material": "film"},
      {"shape": {"type": "cube", "size": 0.7}, "material": "glass", "transforms": [{"rotate": 30, "about": [0, 1, 0]}, {"translate": [2.6, 0, 0.5]}]}]})");
}

/// The share of the pixels in which the two differ by more than two codes of 255.
double share_of_differences(const std::string& text) {
  const auto scene = scene_from_json(text, "clear.json");
  if (!scene) FAIL(scene.error().message);
  const int width = scene->picture.width, height = scene->picture.height;
  auto frame = SceneFrame::create(*scene);
  if (!frame) FAIL(frame.error().message);
  Pipeline pipeline(PipelineOptions{.threads = 1});
  const auto drawn = frame->draw(pipeline);
  REQUIRE(drawn.ok());
  Workers workers(1);
  const auto traced = tracer::TracedScene::create(*scene, workers, {.surfaces = tracer::SurfaceKind::tessellated});
  if (!traced) FAIL(traced.error().message);
  const tracer::RayTracer rays(*traced);
  const auto view = tracer::View::create(*camera_of(scene->camera, 1.5), width, height);
  REQUIRE(view.ok());
  tracer::TraceScratch scratch;
  int different = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Rgba32F& there = drawn->at(x, y);
      const glm::dvec3 difference = rays.radiance(view->ray({x + 0.5, y + 0.5}), scratch) - glm::dvec3(there.r, there.g, there.b);
      different += std::max({std::abs(difference.x), std::abs(difference.y), std::abs(difference.z)}) > 2.0 / 255;
    }
  return different / static_cast<double>(width * height);
}

}  // namespace

TEST_CASE("tracer witness: clear bodies that do not bend light are drawn as they are traced", "[tracer_witness]") {
  CHECK(share_of_differences(clear_scene("1")) < 0.001);    // silhouettes
  CHECK(share_of_differences(clear_scene("1.3")) > 0.05);   // what the pipeline warns of
}

}  // namespace tuberia::witness
