// tuberia witness SCENE.json: what the pipeline and the ray tracer say of the same scene

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
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

constexpr int kLargestWitnessed = 16384;  // pixels each way

/// On a terminal a line for each step, written anew ten times a second at most; elsewhere nothing.
class ProgressLine {
 public:
  void operator()(std::string_view step, double done) {
    if (!is_terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (step == step_ && now - last_ < std::chrono::milliseconds(100)) return;
    if (!step_.empty() && step != step_) std::fprintf(stderr, "\n");
    step_ = step;
    last_ = now;
    std::fprintf(stderr, "\r%-10s %3.0f %%", step_.c_str(), 100 * done);
  }
  void end() const {
    if (!step_.empty()) std::fprintf(stderr, "\n");
  }

 private:
  bool is_terminal_ = isatty(STDERR_FILENO) != 0;
  std::string step_;
  std::chrono::steady_clock::time_point last_{};
};

/// Refused before the work, not after it.
Result<Nothing> check_page(const std::string& page) {
  namespace fs = std::filesystem;
  if (page.empty()) return Nothing{};
  const fs::path path(page);
  if (lower_case_extension(path) != ".html") return Error{page + ": a page is written to a file .html"};
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return Error{page + " is a folder"};
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored)) return Error{page + ": there is no folder " + folder.string()};
  const bool can_be_written = access((fs::exists(path, ignored) ? path : folder).c_str(), W_OK) == 0;
  if (!can_be_written) return Error{page + " cannot be written"};
  return Nothing{};
}

Result<glm::ivec2> size_of(const std::string& text) {
  const auto size = parse_size(text);
  if (!size) return size.error();
  for (const int side : {size->first, size->second})
    if (side < 1 || side > kLargestWitnessed) return Error{"--size " + text + " must be 1 to " + std::to_string(kLargestWitnessed) + " pixels each way"};
  return glm::ivec2(size->first, size->second);
}

int run_witness(const WitnessArguments& arguments) {
  if (const auto checked = check_page(arguments.page); !checked) return fail(checked.error().message);
  auto scene = read_scene(arguments.scene);
  if (!scene) return fail(scene.error().message);
  const auto pipeline = options_of(arguments.pipeline);
  if (!pipeline) return fail(pipeline.error().message);
  ProgressLine progress;
  witness::WitnessOptions options{.size_pixels = {scene->picture.width, scene->picture.height}, .pipeline = *pipeline, .progress = std::ref(progress)};
  if (!arguments.size.empty()) {
    const auto size = size_of(arguments.size);
    if (!size) return fail(size.error().message);
    options.size_pixels = *size;
  }
  auto comparison = witness::compare_witnesses(*scene, *scene, options);
  progress.end();
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
