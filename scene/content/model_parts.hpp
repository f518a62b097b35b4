#pragma once
// Model files as parts of objects.

#include <string>
#include <vector>

#include "scene/content/object_content.hpp"

namespace tuberia {

/// The meshes of a file with its own materials, or with this one. Errors of load_model; its warnings are appended.
Result<std::vector<ContentPart>> parts_of_model(const SceneDescription& scene, const description::ModelFile& shape, const description::Material& material,
                                                std::vector<std::string>& warnings);

}  // namespace tuberia
