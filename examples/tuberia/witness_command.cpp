// tuberia witness SCENE.json: what the pipeline and the ray tracer say of the same scene

#include <chrono>
#include <cstdio>
#include <memory>
#include <span>

#include "examples/tuberia/commands.hpp"
#include "examples/tuberia/picture_options.hpp"
#include "examples/tuberia/pipeline_options.hpp"
#include "examples/tuberia/witness/witness.hpp"
#include "image/file.hpp"
#include "scene/description/read_scene.hpp"

namespace tuberia::cli {
namespace {

struct WitnessArguments {
  std::string scene, page, size;
  PipelineArguments pipeline;
};

/// A line on the terminal, ten times a second at most, and one for each step.
class ProgressLine {
 public:
  void operator()(std::string_view step, double done) {
    const auto now = std::chrono::steady_clock::now();
    if (step == step_ && now - last_ < std::chrono::milliseconds(100)) return;
    if (!step_.empty() && step != step_) std::fprintf(stderr, "\n");
    step_ = step;
    last_ = now;
    std::fprintf(stderr, "\r%-10s %3.0f %%", step_.c_str(), 100 * done);
  }

 private:
  std::string step_;
  std::chrono::steady_clock::time_point last_{};
};

int run_witness(const WitnessArguments& arguments) {
  auto scene = read_scene(arguments.scene);
  if (!scene) return fail(scene.error().message);
  const auto pipeline = options_of(arguments.pipeline);
  if (!pipeline) return fail(pipeline.error().message);
  witness::WitnessOptions options{.size_pixels = {scene->picture.width, scene->picture.height}, .pipeline = *pipeline, .progress = ProgressLine()};
  if (!arguments.size.empty()) {
    const auto size = parse_size(arguments.size);
    if (!size) return fail(size.error().message);
    options.size_pixels = {size->first, size->second};
  }
  auto comparison = witness::compare_witnesses(*scene, *scene, options);
  std::fprintf(stderr, "\n");
  if (!comparison) return fail(arguments.scene + ": " + comparison.error().message);
  comparison->file = arguments.scene;
  if (!arguments.page.empty()) {
    const std::string page = page_of(*comparison);
    if (const auto written = write_file(arguments.page, std::as_bytes(std::span(page))); !written) return fail(written.error().message);
  }
  std::printf("%s", summary_of(*comparison).c_str());
  return is_confirmed(counts_of(*comparison)) ? kFine : kDifferent;
}

}  // namespace

Run add_witness(CLI::App& parent, CLI::App*& command) {
  const auto arguments = std::make_shared<WitnessArguments>();
  command = parent.add_subcommand("witness", "Draw a scene, trace it by rays, and explain every pixel that differs; exit status 1 if one cannot be explained");
  command->add_option("scene", arguments->scene, "Scene file, .json")->required();
  command->add_option("-o,--output", arguments->page, "Write a page that shows both pictures, their difference and the reasons, .html");
  command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels, in place of the scene's own");
  add_pipeline_options(*command, arguments->pipeline);
  return [arguments] { return run_witness(*arguments); };
}

}  // namespace tuberia::cli
