#pragma once
// What a model file holds.

#include <cstdint>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "scene/material.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// An image that materials refer to. (The pipeline's Texture is made from it, with its mipmaps.)
struct ModelTexture {
  std::string name;     // as the model's file gives it
  Image<Rgba8> image;   // sRGB codes, straight alpha; never empty
  bool missing = false; // could not be found or read; the image is a magenta and black checker

  bool operator==(const ModelTexture&) const = default;
};

/// Meshes in one object space, with what they refer to.
struct Model {
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<ModelTexture> textures;
  std::vector<std::string> warnings;  // one line each: what was repaired, replaced or left out

  std::int64_t triangle_count() const noexcept;
  std::int64_t vertex_count() const noexcept;
  Bounds bounds() const noexcept;
};

}  // namespace tuberia
