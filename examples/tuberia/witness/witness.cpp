#include "examples/tuberia/witness/witness.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>

#include "examples/tuberia/witness/explaining.hpp"
#include "scene/content/develop.hpp"
#include "scene/content/object_content.hpp"
#include "scene/content/scene_camera.hpp"
#include "scene/frame/scene_frame.hpp"

namespace tuberia::witness {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); }

/// One thing after the other is told to whoever waits.
class Progress {
 public:
  Progress(const WitnessOptions& options, std::string_view step, int rows) : told_(options.progress), step_(step), rows_(rows) {
    if (told_) told_(step_, 0);
  }
  void row_done(int worker) {
    const int done = ++done_;
    if (told_ && worker == 0) told_(step_, static_cast<double>(done) / rows_);
  }

 private:
  const std::function<void(std::string_view, double)>& told_;
  std::string_view step_;
  int rows_;
  std::atomic<int> done_{0};
};

struct Drawn {
  Image<Rgba8> codes;
  Image<int> objects;
  Development development;
};

Development development_of(const Image<Rgba32F>& light, const description::Picture& picture) {
  Development development{.factor = std::exp2(picture.exposure_stops), .overflow = picture.overflow};
  if (picture.overflow != description::Overflow::global_scale) return development;
  float largest = 0;
  for (const Rgba32F& pixel : light.pixels()) largest = std::max({largest, pixel.r, pixel.g, pixel.b});
  development.factor /= std::max(static_cast<double>(largest) * development.factor, 1.0);
  return development;
}

Result<Drawn> draw(SceneDescription scene, const WitnessOptions& options) {
  Progress progress(options, "drawing", 1);
  scene.picture.supersampling = 1;
  const description::Picture picture = scene.picture;
  auto frame = SceneFrame::create(std::move(scene), {.size_pixels = options.size_pixels});
  if (!frame) return frame.error();
  Pipeline pipeline(options.pipeline);
  auto light = frame->draw(pipeline);
  if (!light) return light.error();
  auto nearest = frame->nearest_objects(pipeline);
  if (!nearest) return nearest.error();
  const Development development = development_of(*light, picture);
  return Drawn{.codes = srgb_codes_of(developed(*std::move(light), picture)), .objects = std::move(nearest->objects), .development = development};
}

struct Traced {
  Image<Rgba8> codes;
  Image<int> objects;
};

/// One ray through the centre of each pixel.
Traced trace(const tracer::RayTracer& tracer, const Imitation& imitation, const Development& development, Workers& workers, const WitnessOptions& options) {
  const glm::ivec2 size = options.size_pixels;
  Traced traced{Image<Rgba8>(size.x, size.y), Image<int>(size.x, size.y)};
  Progress progress(options, "tracing", size.y);
  std::vector<tracer::TraceScratch> scratches(static_cast<std::size_t>(workers.thread_count()));
  parallel_for(workers, size.y, [&](std::int64_t row, int worker) {
    const int y = static_cast<int>(row);
    tracer::TraceScratch& scratch = scratches[static_cast<std::size_t>(worker)];
    for (int x = 0; x < size.x; ++x) {
      const auto ray = [&](int i, int j) { return imitation.ray({.pixel = {x + i, y + j}}); };
      const tracer::NeighbourRays neighbours{.right = ray(1, 0), .down = ray(0, 1)};
      const tracer::Hit hit = tracer.first_hit(ray(0, 0), scratch);
      traced.objects.at(x, y) = hit ? tracer.scene().object_of(hit.item) : -1;
      traced.codes.at(x, y) = development.code(tracer.radiance(ray(0, 0), scratch, nullptr, &neighbours));
    }
    progress.row_done(worker);
  });
  return traced;
}

void explain(Comparison& comparison, const Explaining& explaining, Workers& workers, const WitnessOptions& options) {
  const glm::ivec2 size = options.size_pixels;
  comparison.verdicts = Image<PixelVerdict>(size.x, size.y);
  Progress progress(options, "explaining", size.y);
  std::vector<tracer::TraceScratch> scratches(static_cast<std::size_t>(workers.thread_count()));
  parallel_for(workers, size.y, [&](std::int64_t row, int worker) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < size.x; ++x) {
      const DrawnPixel drawn{.colour = comparison.drawn.at(x, y), .object = comparison.drawn_objects.at(x, y)};
      const bool is_same = drawn.object == comparison.traced_objects.at(x, y) && difference(drawn.colour, comparison.traced.at(x, y)) <= kToleratedCodes;
      if (!is_same) comparison.verdicts.at(x, y) = explaining.verdict({x, y}, drawn, scratches[static_cast<std::size_t>(worker)]);
    }
    progress.row_done(worker);
  });
}

std::vector<std::string> names_of_objects(const SceneDescription& scene) {
  std::vector<std::string> names;
  for (const description::Object& object : scene.objects) names.push_back(name_of_object(scene, object));
  return names;
}

/// The order in which surfaces are blended is no question of formulas: nothing imitates it.
std::vector<std::string> remarks_on(const SceneDescription& scene) {
  std::vector<std::string> remarks;
  for (const description::Object& object : scene.objects) {
    const description::Material* material = find_material(scene, object.material);
    if (material != nullptr && material->alpha < 1)
      remarks.push_back(name_of_object(scene, object) + " is blended: where several of its surfaces lie one behind the other, the pipeline blends them in the order of its triangles, "
                                                        "rays in the order of depth. Such pixels stay unexplained.");
  }
  return remarks;
}

}  // namespace

Result<Comparison> compare_witnesses(const SceneDescription& drawn, const SceneDescription& traced, const WitnessOptions& options) {
  Comparison comparison{.title = drawn.title, .source = drawn.source, .file = {}, .drawn = {}, .traced = {}, .drawn_objects = {}, .traced_objects = {}, .verdicts = {},
                        .object_names = names_of_objects(drawn), .remarks = remarks_on(drawn)};
  auto begin = std::chrono::steady_clock::now();
  auto picture = draw(drawn, options);
  if (!picture) return picture.error();
  comparison.drawing_seconds = seconds_since(begin);

  begin = std::chrono::steady_clock::now();
  Workers workers(options.pipeline.threads);
  const auto scene = tracer::TracedScene::create(traced, workers, {.surfaces = tracer::SurfaceKind::tessellated});
  if (!scene) return scene.error();
  const auto camera = camera_of(traced.camera, static_cast<double>(options.size_pixels.x) / options.size_pixels.y);
  if (!camera) return Error{"camera: " + camera.error().message};
  const auto imitation = Imitation::create(*scene, *camera, options.size_pixels, workers);
  if (!imitation) return imitation.error();
  const tracer::RayTracer tracer(*scene);
  Traced by_rays = trace(tracer, *imitation, picture->development, workers, options);
  comparison.tracing_seconds = seconds_since(begin);

  begin = std::chrono::steady_clock::now();
  comparison.drawn = std::move(picture->codes);
  comparison.drawn_objects = std::move(picture->objects);
  comparison.traced = std::move(by_rays.codes);
  comparison.traced_objects = std::move(by_rays.objects);
  explain(comparison, Explaining(*imitation, tracer, *camera, picture->development), workers, options);
  comparison.explaining_seconds = seconds_since(begin);
  return comparison;
}

}  // namespace tuberia::witness
