#include "examples/tuberia/gallery/gallery_rays.hpp"

#include <chrono>
#include <cstdio>

#include "examples/tuberia/gallery/gallery.hpp"
#include "examples/tuberia/gallery/plot.hpp"
#include "examples/tuberia/render_model.hpp"
#include "reference/ray_tracer/ray_tree.hpp"
#include "reference/ray_tracer/trace_scene.hpp"
#include "scene/content/develop.hpp"
#include "scene/content/scene_camera.hpp"
#include "scene/description/read_scene.hpp"

namespace tuberia::cli {
namespace {

using description::Sampling;

constexpr const char* kTwoMirrors = "62_two_mirrors.json";

Result<Image<Rgba8>> traced(const SceneDescription& scene, Workers& workers) {
  auto picture = tracer::trace_scene(scene, workers);
  if (!picture) return picture.error();
  return srgb_codes_of(developed(std::move(picture->light), scene.picture));
}

/// Each pixel as a square of size x size pixels.
Image<Rgba8> magnified(const Image<Rgba8>& picture, int size) {
  Image<Rgba8> large(picture.width() * size, picture.height() * size);
  for (int y = 0; y < large.height(); ++y)
    for (int x = 0; x < large.width(); ++x) large.at(x, y) = picture.at(x / size, y / size);
  return large;
}

/// The part of figure 49 around the lower right corner of the mirror on the wall.
Result<Image<Rgba8>> draw_samples(const std::filesystem::path& scenes, Workers& workers, Sampling::Pattern pattern) {
  auto scene = read_scene(scenes / kTwoMirrors);
  if (!scene) return scene.error();
  scene->picture.width = scene->picture.height = 104;
  scene->camera.look_at = {1.95, 0.8, -3.88};
  scene->camera.fovy_degrees = 7;
  std::vector<Image<Rgba8>> pictures;
  for (const int per_pixel : {1, 4, 9}) {
    scene->tracing.sampling = {.pattern = pattern, .per_pixel = per_pixel};
    const auto picture = traced(*scene, workers);
    if (!picture) return picture.error();
    pictures.push_back(magnified(*picture, 3));
  }
  return side_by_side(pictures);
}

}  // namespace

Result<GalleryDrawing> traced_drawing(const std::filesystem::path& file, Workers& workers) {
  const auto scene = read_scene(file);
  if (!scene) return scene.error();
  const auto start = std::chrono::steady_clock::now();
  auto picture = tracer::trace_scene(*scene, workers);
  if (!picture) return Error{file.string() + ": " + picture.error().message};
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  char performance[128];
  const tracer::TraceCounts& counts = picture->counts;
  std::snprintf(performance, sizeof performance, "%s rays from the eye, %s by mirrors and glass, %s to lights, %.1f s", with_commas(counts.eye_rays).c_str(),
                with_commas(counts.reflected_rays + counts.transmitted_rays).c_str(), with_commas(counts.shadow_rays).c_str(), seconds);
  return GalleryDrawing{srgb_codes_of(developed(std::move(picture->light), scene->picture)), scene->title, scene->source, scene->caption, performance};
}

bool is_ray_tree(const std::string& name) { return name == "61_ray_tree"; }

Result<GalleryDrawing> ray_tree_drawing(const std::filesystem::path& file, Workers& workers) {
  const auto scene = read_scene(file);
  if (!scene) return scene.error();
  const glm::dvec2 size(scene->picture.width, scene->picture.height);
  const auto traced_scene = tracer::TracedScene::create(*scene, workers);
  const auto camera = camera_of(scene->camera, size.x / size.y);
  const auto view = camera ? tracer::View::create(*camera, scene->picture.width, scene->picture.height) : camera.error();
  if (!traced_scene || !view) return Error{file.string() + ": " + (traced_scene ? view.error() : traced_scene.error()).message};
  const tracer::RayTracer tracer(*traced_scene, {.most_level = scene->tracing.depth, .least_weight = scene->tracing.least_weight});
  tracer::TraceScratch scratch;
  tracer::RayTree tree;
  tracer.radiance(view->ray(0.5 * size), scratch, &tree);
  return GalleryDrawing{{}, scene->title, scene->source, scene->caption, std::to_string(tree.rays().size()) + " rays for one pixel", svg_of(tree)};
}

Result<Image<Rgba8>> draw_depths_of_reflection(const std::filesystem::path& scenes, Pipeline& pipeline) {
  auto scene = read_scene(scenes / kTwoMirrors);
  if (!scene) return scene.error();
  scene->picture.width = scene->picture.height = 250;
  scene->tracing.sampling.per_pixel = 9;
  std::vector<Image<Rgba8>> rows, row;
  for (scene->tracing.depth = 0; scene->tracing.depth <= 3; ++scene->tracing.depth) {
    auto picture = traced(*scene, pipeline.workers());
    if (!picture) return picture.error();
    row.push_back(*std::move(picture));
    if (row.size() == 2) rows.push_back(side_by_side(std::exchange(row, {})));
  }
  return stacked(rows);
}

Result<Image<Rgba8>> draw_uniform_samples(const std::filesystem::path& scenes, Pipeline& pipeline) {
  return draw_samples(scenes, pipeline.workers(), Sampling::Pattern::uniform);
}

Result<Image<Rgba8>> draw_jittered_samples(const std::filesystem::path& scenes, Pipeline& pipeline) {
  return draw_samples(scenes, pipeline.workers(), Sampling::Pattern::jittered);
}

}  // namespace tuberia::cli
