#pragma once
// Files that a model refers to, in whatever way some other machine wrote their names.

#include <filesystem>
#include <optional>
#include <string>

#include "scene/model.hpp"

namespace tuberia {

/// The file that `name` means for a model in `folder`: relative to the folder, with '/' or '\'
/// and upper and lower case alike, or else its last part in the folder itself. Nothing if there
/// is no such file. Among several that differ only in case, the first in byte order.
std::optional<std::filesystem::path> find_beside_model(const std::filesystem::path& folder,
                                                       const std::string& name);

/// A checker of magenta and black, which nobody takes for the texture that was meant.
ModelTexture missing_texture(const std::string& name);

}  // namespace tuberia
