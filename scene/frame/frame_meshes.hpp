#pragma once
// The objects of a scene as the pipeline draws them.

#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "raster/texture.hpp"
#include "scene/content/object_content.hpp"

namespace tuberia {

/// What of an object has one material; as ContentPart, with textures for pictures.
struct FramePart {
  Mesh mesh;
  description::Material material;
  std::shared_ptr<const Texture> own_texture{}, own_normals{};
  float alpha_cutoff = 0;
};

/// What content_of gives. Errors: of content_of, and pictures of a size that textures cannot have. Warnings are
/// appended: of content_of, for colours at vertices that no fragment program reads, for what is seen through but not
/// bent, and for mirrors of nothing.
Result<std::vector<FramePart>> parts_of(const SceneDescription& scene, const description::Object& object, std::vector<std::string>& warnings);

}  // namespace tuberia
