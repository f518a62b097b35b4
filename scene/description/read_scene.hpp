#pragma once
// Scene files: JSON, see docs/scene_file.md.

#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "scene/description/scene_description.hpp"

namespace tuberia {

/// The scene in a file; its folder is the file's. Every key is understood or refused.
/// Errors, one line each, with file, line and key: `teapot.json:14: materials.red.exponent is -3, but must
/// be 0 or more`. Bad syntax (with its column), keys that are there twice, unknown or missing, values of the
/// wrong kind or out of range, and names of textures or materials that are not there. The files that a scene
/// names are not looked at.
Result<SceneDescription> read_scene(const std::filesystem::path& path);

/// The same for a text; `name` names it in an error.
Result<SceneDescription> scene_from_json(std::string_view text, std::string_view name);

/// A text that reads as the same scene, but for its folder.
std::string json_of_scene(const SceneDescription& scene);

/// The page of all keys, as Markdown: docs/scene_file.md.
std::string scene_file_page();

}  // namespace tuberia
