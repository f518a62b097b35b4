#pragma once
// The pictures that a scene names, read or made.

#include <memory>

#include "base/result.hpp"
#include "image/image.hpp"
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

/// Its linear intensities, as a picture. Errors as above.
Result<Image<Rgba32F>> picture_of(const SceneDescription& scene, const description::Texture& texture);

Sampler sampler_of(const description::Texture& texture) noexcept;

}  // namespace tuberia
