#pragma once
// tuberia render SCENE.json: what a scene file says, and little that the command line could add.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "base/result.hpp"
#include "pipeline/pipeline.hpp"
#include "scene/frame/scene_frame.hpp"

namespace tuberia::cli {

bool is_scene_file(const std::string& path);

struct SceneArguments {
  std::string scene, output;
  std::optional<glm::ivec2> size_pixels;  // instead of the scene's own
  std::optional<int> supersampling;
  double time = 0;
  bool statistics = false;
};

/// Error naming the first option on the command line that a scene file leaves no room for.
Result<Nothing> check_scene_options(const CLI::App& command);

/// Floats as the light of the scene, all else as the picture that its camera makes of it.
Result<Nothing> write_scene_picture(const std::string& output, const Image<Rgba32F>& light, const description::Picture& picture);

/// Draws, writes and reports; the exit status.
int render_scene(const SceneArguments& arguments, const PipelineOptions& options);

}  // namespace tuberia::cli
