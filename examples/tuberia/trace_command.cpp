// tuberia trace SCENE.json -o FILE, and the tree of one pixel's rays

#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "examples/tuberia/commands.hpp"
#include "examples/tuberia/picture_options.hpp"
#include "examples/tuberia/render_model.hpp"
#include "examples/tuberia/render_scene.hpp"
#include "image/file.hpp"
#include "image/write_image.hpp"
#include "reference/ray_tracer/ray_tree.hpp"
#include "reference/ray_tracer/render.hpp"
#include "scene/content/scene_camera.hpp"
#include "scene/description/read_scene.hpp"

namespace tuberia::cli {
namespace {

using tracer::AcceleratorKind;
using tracer::TracedScene;
using Clock = std::chrono::steady_clock;

constexpr AcceleratorKind kAccelerators[] = {AcceleratorKind::none, AcceleratorKind::bounding_spheres, AcceleratorKind::bvh, AcceleratorKind::grid, AcceleratorKind::octree};
constexpr int kLargestPicture = 16384;  // pixels each way

struct TraceArguments {
  std::string scene, output, size, accelerator = "bvh", surfaces = "exact", pattern = "uniform", filter = "box", pixel, tree;
  int depth = 5, samples = 1, threads = 0;
  double least_weight = 0, time = 0;
  bool adaptive = false, statistics = false;
};

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// On a terminal one line that is written again and again, elsewhere a line now and then.
class TimeLeft {
 public:
  void operator()(double done, double seconds_left) {
    const double wanted_seconds = is_terminal_ ? 0.2 : 5;
    if (seconds_since(last_) < wanted_seconds) return;
    last_ = Clock::now();
    was_written_ = true;
    std::fprintf(stderr, "%s%3.0f %%, %.0f s left%s", is_terminal_ ? "\r" : "", 100 * done, seconds_left, is_terminal_ ? "   " : "\n");
  }
  void end() const {
    if (was_written_ && is_terminal_) std::fprintf(stderr, "\r%30s\r", "");
  }

 private:
  bool is_terminal_ = isatty(STDERR_FILENO) != 0, was_written_ = false;
  Clock::time_point last_ = Clock::now();
};

/// "12,34" to a pixel of the picture.
Result<glm::ivec2> parse_pixel(const std::string& text, const description::Picture& picture) {
  glm::ivec2 pixel(0);
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, pixel.x);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != ',') return Error{"--pixel: '" + text + "' is not a pixel like 12,34"};
  const auto second = std::from_chars(first.ptr + 1, end, pixel.y);
  if (second.ec != std::errc{} || second.ptr != end) return Error{"--pixel: '" + text + "' is not a pixel like 12,34"};
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= picture.width || pixel.y >= picture.height)
    return Error{"--pixel " + text + " is outside of the picture, which has " + std::to_string(picture.width) + "x" + std::to_string(picture.height) + " pixels"};
  return pixel;
}

/// What the command line says goes before what the scene says.
Result<Nothing> apply(const TraceArguments& arguments, const CLI::App& command, SceneDescription& scene) {
  description::Sampling& sampling = scene.tracing.sampling;
  if (command.count("--depth") > 0) scene.tracing.depth = arguments.depth;
  if (command.count("--least-weight") > 0) scene.tracing.least_weight = arguments.least_weight;
  if (command.count("--samples") > 0) sampling.per_pixel = arguments.samples;
  if (command.count("--adaptive") > 0) sampling.adaptive = arguments.adaptive;
  if (command.count("--pattern") > 0) sampling.pattern = arguments.pattern == "jittered" ? description::Sampling::Pattern::jittered : description::Sampling::Pattern::uniform;
  if (command.count("--filter") > 0) sampling.filter = arguments.filter == "gaussian" ? description::Sampling::Filter::gaussian : description::Sampling::Filter::box;
  const int root = static_cast<int>(std::lround(std::sqrt(sampling.per_pixel)));
  if (root * root != sampling.per_pixel) return Error{"--samples is " + std::to_string(sampling.per_pixel) + ", but must be a square number"};
  if (command.count("--size") == 0) return Nothing{};
  const auto size = parse_size(arguments.size);
  if (!size) return size.error();
  for (const int side : {size->first, size->second})
    if (side < 1 || side > kLargestPicture) return Error{"--size " + arguments.size + " must be 1 to " + std::to_string(kLargestPicture) + " pixels each way"};
  std::tie(scene.picture.width, scene.picture.height) = *size;
  return Nothing{};
}

Result<Nothing> check(const TraceArguments& arguments) {
  if (!is_scene_file(arguments.scene)) return Error{"'" + arguments.scene + "' is no scene: rays are traced through scene files, .json"};
  if (arguments.pixel.empty() != arguments.tree.empty()) return Error{arguments.tree.empty() ? "--pixel goes with --tree, a file for its rays" : "--tree goes with --pixel, whose rays it shows"};
  if (arguments.output.empty() && arguments.tree.empty()) return Error{"--output or --tree is required: a file to write"};
  if (!std::isfinite(arguments.time)) return Error{"--time is not a number"};
  // What cannot be written is not traced first.
  if (!arguments.output.empty())
    if (const auto good = check_picture_path(arguments.output); !good) return good;
  if (!arguments.tree.empty()) return check_writable(arguments.tree);
  return Nothing{};
}

void print_statistics(const tracer::TracedPicture& picture, const TracedScene& scene) {
  const tracer::TraceCounts& counts = picture.counts;
  const tracer::AcceleratorFacts facts = scene.accelerator().facts();
  const auto print = [](const char* what, std::int64_t count) { std::printf("%-20s  %s\n", what, with_commas(count).c_str()); };
  print("eye rays", counts.eye_rays);
  print("reflected rays", counts.reflected_rays);
  print("transmitted rays", counts.transmitted_rays);
  print("shadow rays", counts.shadow_rays);
  print("over the budget", counts.unfollowed_rays);
  print("items", scene.geometry().count());
  print("item tests", counts.work.item_tests);
  print("volume tests", counts.work.volume_tests);
  std::printf("accelerator           %s volumes, depth %d, %s bytes, built in %.3f s\n", with_commas(facts.volumes).c_str(), facts.depth, with_commas(facts.memory_bytes).c_str(),
              facts.build_seconds);
}

Result<Nothing> write_tree(const TraceArguments& arguments, const tracer::RayTracer& tracer, const tracer::View& view) {
  const auto pixel = parse_pixel(arguments.pixel, tracer.scene().description().picture);
  if (!pixel) return pixel.error();
  tracer::TraceScratch scratch;
  tracer::RayTree tree;
  const glm::dvec2 centre = glm::dvec2(*pixel) + 0.5;
  const tracer::NeighbourRays neighbours{.right = view.ray(centre + glm::dvec2(1, 0)), .down = view.ray(centre + glm::dvec2(0, 1))};
  const glm::dvec3 light = tracer.radiance(view.ray(centre), scratch, &tree, &neighbours);
  if (const auto written = write_ray_tree(arguments.tree, tree); !written) return written.error();
  std::printf("%s: %s rays, light %.6g %.6g %.6g\n", arguments.tree.c_str(), with_commas(static_cast<std::int64_t>(tree.rays().size())).c_str(), light.r, light.g, light.b);
  return Nothing{};
}

Result<Nothing> write_picture(const TraceArguments& arguments, const tracer::RayTracer& tracer, const tracer::View& view, Workers& workers) {
  const description::Picture& picture = tracer.scene().description().picture;
  const auto begin = Clock::now();
  TimeLeft progress;
  const tracer::TracedPicture traced = render(tracer, view, picture.width, picture.height, tracer.scene().description().tracing.sampling, workers, std::ref(progress));
  progress.end();
  if (const auto written = write_scene_picture(arguments.output, traced.light, picture); !written) return written.error();
  const tracer::TraceCounts& counts = traced.counts;
  std::printf("%s: %dx%d pixels, %s rays, %.2f s, %d %s\n", arguments.output.c_str(), picture.width, picture.height,
              with_commas(counts.eye_rays + counts.reflected_rays + counts.transmitted_rays + counts.shadow_rays).c_str(), seconds_since(begin), workers.thread_count(),
              workers.thread_count() == 1 ? "thread" : "threads");
  if (arguments.statistics) print_statistics(traced, tracer.scene());
  return Nothing{};
}

AcceleratorKind accelerator_named(const std::string& name) {
  for (const AcceleratorKind kind : kAccelerators)
    if (tracer::name_of(kind) == name) return kind;
  return AcceleratorKind::bvh;
}

Result<Nothing> trace(const TraceArguments& arguments, SceneDescription description) {
  const double aspect = static_cast<double>(description.picture.width) / description.picture.height;
  const auto camera = camera_of(description.camera, aspect, arguments.time);
  if (!camera) return camera.error();
  const auto view = tracer::View::create(*camera, description.picture.width, description.picture.height);
  if (!view) return view.error();

  Workers workers(arguments.threads);
  const auto kind = arguments.surfaces == "tessellated" ? tracer::SurfaceKind::tessellated : tracer::SurfaceKind::exact;
  const auto scene = TracedScene::create(std::move(description), workers, {.surfaces = kind, .accelerator = accelerator_named(arguments.accelerator), .time = arguments.time});
  if (!scene) return scene.error();
  for (const std::string& warning : scene->warnings()) std::fprintf(stderr, "tuberia: warning: %s\n", warning.c_str());

  const description::Tracing& tracing = scene->description().tracing;
  const tracer::RayTracer tracer(*scene, {.most_level = tracing.depth, .least_weight = tracing.least_weight});
  if (!arguments.tree.empty())
    if (const auto written = write_tree(arguments, tracer, *view); !written) return written.error();
  if (arguments.output.empty()) return Nothing{};
  return write_picture(arguments, tracer, *view, workers);
}

int run_trace(const TraceArguments& arguments, const CLI::App& command) {
  if (const auto good = check(arguments); !good) return fail(good.error().message);
  auto scene = read_scene(arguments.scene);
  if (!scene) return fail(scene.error().message);
  if (const auto good = apply(arguments, command, *scene); !good) return fail(good.error().message);
  const auto traced = trace(arguments, *std::move(scene));
  return traced ? kFine : fail(arguments.scene + ": " + traced.error().message);
}

void add_sampling_options(CLI::App& command, TraceArguments& arguments) {
  command.add_option("--samples", arguments.samples, "Rays for a pixel, a square number")->check(CLI::Range(1, 1024))->group("Sampling");
  command.add_option("--pattern", arguments.pattern, "Where they lie")->check(CLI::IsMember({"uniform", "jittered"}))->group("Sampling");
  command.add_option("--filter", arguments.filter, "How they become a colour")->check(CLI::IsMember({"box", "gaussian"}))->group("Sampling");
  command.add_flag("--adaptive,!--no-adaptive", arguments.adaptive, "So many only where the corners of a pixel, or of its parts, differ")->group("Sampling");
}

}  // namespace

Run add_trace(CLI::App& parent, CLI::App*& command) {
  const auto arguments = std::make_shared<TraceArguments>();
  command = parent.add_subcommand("trace", "Trace rays through a scene file to a picture, or to the tree of one pixel's rays");
  // What is not given is what the scene says.
  command->option_defaults()->always_capture_default(false);
  command->add_option("scene", arguments->scene, "A scene, .json")->required();
  command->add_option("-o,--output", arguments->output, "Picture to write: .png, .ppm, .tga, .bmp, .jpg, .pfm, .hdr");
  command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels");
  command->add_option("--depth", arguments->depth, "Level of the last rays that are followed; those from the eye are 0")->check(CLI::Range(0, 1000));
  command->add_option("--least-weight", arguments->least_weight, "Branches whose coefficients multiply to less are not followed")->check(CLI::Range(0.0, 1.0));
  std::vector<std::string> accelerators;
  for (const AcceleratorKind kind : kAccelerators) accelerators.emplace_back(tracer::name_of(kind));
  command->add_option("--accelerator", arguments->accelerator, "How the nearest object is found; the picture is the same")->check(CLI::IsMember(accelerators));
  command->add_option("--surfaces", arguments->surfaces, "exact: spheres are spheres; tessellated: the triangles that the pipeline draws")
      ->check(CLI::IsMember({"exact", "tessellated"}));
  command->add_option("--threads", arguments->threads, "0: one a core")->check(CLI::Range(0, 1024));
  command->add_option("--time", arguments->time, "How far the scene's camera has moved")->check(CLI::Range(0.0, 1.0));
  command->add_flag("--stats", arguments->statistics, "Print what was traced");
  command->add_option("--pixel", arguments->pixel, "X,Y from the upper left corner: --tree shows the ray through its centre, and all that come of it")->group("Ray tree");
  command->add_option("--tree", arguments->tree, "File for them: .dot, .json or .svg")->group("Ray tree");
  add_sampling_options(*command, *arguments);
  return [arguments, command] { return run_trace(*arguments, *command); };
}

}  // namespace tuberia::cli
