#pragma once
// The pictures that a scene names, as textures.

#include <memory>

#include "base/result.hpp"
#include "pipeline/programs/texture_access.hpp"
#include "raster/sampler.hpp"
#include "raster/texture.hpp"
#include "scene/description/scene_description.hpp"

namespace tuberia {

struct FrameTexture {
  std::shared_ptr<const Texture> texture;
  Sampler sampler;
  TextureAccess access{};  // by which rule its level is chosen
};

/// With its mipmaps. Errors: of the file's reader, and a size that textures cannot have; they name the texture.
Result<FrameTexture> frame_texture(const SceneDescription& scene, const description::Texture& texture);

Sampler sampler_of(const description::Texture& texture) noexcept;

}  // namespace tuberia
