#pragma once
// The pictures that a scene names, read or made.

#include "base/result.hpp"
#include "image/image.hpp"
#include "scene/description/scene_description.hpp"

namespace tuberia {

/// A texture's finest level: codes, or linear intensities where the codes are empty. Colours are codes, which are read faster
/// than floats; what may be a height is not rounded to them.
struct TexturePicture {
  Image<Rgba8> codes;
  bool is_srgb = false;     // the codes; their alpha is linear
  Image<Rgba32F> light;
};

/// Errors: of the file's reader; they name the texture.
Result<TexturePicture> texture_picture(const SceneDescription& scene, const description::Texture& texture);

/// Its linear intensities; those that are made are not rounded to codes. Errors as above.
Result<Image<Rgba32F>> picture_of(const SceneDescription& scene, const description::Texture& texture);

/// What a picture's codes stand for, or its light as it is.
Image<Rgba32F> light_of(const TexturePicture& picture);

}  // namespace tuberia
