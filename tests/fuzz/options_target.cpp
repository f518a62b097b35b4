#include <algorithm>
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "examples/tuberia/picture_options.hpp"
#include "examples/tuberia/pipeline_options.hpp"
#include "tests/fuzz/targets.hpp"

namespace tuberia::fuzz {
namespace {

/// One argument a line, the last first, as CLI11 wants them.
std::vector<std::string> arguments_of(Input input) {
  std::vector<std::string> arguments(1);
  for (const std::uint8_t byte : input) {
    if (byte == '\n') arguments.emplace_back();
    else arguments.back() += static_cast<char>(byte);
  }
  if (arguments.back().empty()) arguments.pop_back();
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

Model triangle() {
  Model model;
  model.materials.emplace_back();
  Mesh& mesh = model.meshes.emplace_back();
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5f}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.indices = {0, 1, 2};
  return model;
}

}  // namespace

std::string try_options(Input input) {
  CLI::App app;
  cli::PictureArguments picture;
  cli::PipelineArguments pipeline_arguments;
  cli::add_picture_options(app, picture);
  cli::add_pipeline_options(app, pipeline_arguments);
  try {
    app.parse(arguments_of(input));
  } catch (const CLI::ParseError&) {
    return {};
  }
  const auto options = cli::render_options_of(picture);
  const auto pipeline_options = cli::options_of(pipeline_arguments);
  if (!options || !pipeline_options) return {};

  // Of what they say, a small picture on one thread.
  cli::RenderOptions small = *options;
  small.width_pixels = std::min(small.width_pixels, 40);
  small.height_pixels = std::min(small.height_pixels, 30);
  small.frames = 1;
  PipelineOptions one_thread = *pipeline_options;
  one_thread.threads = 1;
  static const Model model = triangle();
  Pipeline pipeline(one_thread);
  const auto rendering = cli::render(model, small, pipeline);
  if (rendering) return {};
  const std::string& message = rendering.error().message;
  return message.empty() || message.find('\n') != std::string::npos ? "an error of several lines: " + message : "";
}

}  // namespace tuberia::fuzz
