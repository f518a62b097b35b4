#include "scene/convert_assimp.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>

#include "image/file.hpp"
#include "image/limits.hpp"
#include "image/read_image.hpp"
#include "math/colour.hpp"
#include "scene/find_texture.hpp"

namespace tuberia {
namespace {

float clamped(float value, float largest) { return value > 0.0f ? std::min(value, largest) : 0.0f; }

glm::vec3 linear(const aiColor3D& colour, ColourSpace space) {
  const auto decode = [&](float value) {
    const float in_range = clamped(value, 1.0f);
    return space == ColourSpace::linear ? in_range : static_cast<float>(linear_from_srgb(in_range));
  };
  return {decode(colour.r), decode(colour.g), decode(colour.b)};
}

Material convert_material(const aiMaterial& from, ColourSpace space) {
  Material to;
  aiString name, alpha_mode;
  if (from.Get(AI_MATKEY_NAME, name) == AI_SUCCESS) to.name = name.C_Str();

  aiColor3D colour;
  float number = 0.0f;
  if (from.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS)
    to.base_colour = glm::vec4(linear(colour, space), 1.0f);
  if (from.Get(AI_MATKEY_OPACITY, number) == AI_SUCCESS) to.base_colour.a = clamped(number, 1.0f);
  // Many exporters write transparency where opacity belongs. Nobody models what cannot be seen.
  if (to.base_colour.a == 0.0f) to.base_colour.a = 1.0f;
  if (from.Get(AI_MATKEY_COLOR_AMBIENT, colour) == AI_SUCCESS) to.ambient = linear(colour, space);
  if (from.Get(AI_MATKEY_COLOR_SPECULAR, colour) == AI_SUCCESS) to.specular = linear(colour, space);
  if (from.Get(AI_MATKEY_SHININESS, number) == AI_SUCCESS) to.shininess = clamped(number, 1e6f);
  if (from.Get(AI_MATKEY_SHININESS_STRENGTH, number) == AI_SUCCESS) to.specular *= clamped(number, 1.0f);

  int two_sided = 0;
  to.two_sided = from.Get(AI_MATKEY_TWOSIDED, two_sided) == AI_SUCCESS && two_sided != 0;
  if (from.Get(AI_MATKEY_GLTF_ALPHAMODE, alpha_mode) == AI_SUCCESS &&
      std::strcmp(alpha_mode.C_Str(), "MASK") == 0) {
    to.alpha_cutoff =
        from.Get(AI_MATKEY_GLTF_ALPHACUTOFF, number) == AI_SUCCESS ? clamped(number, 1.0f) : 0.5f;
  }
  return to;
}

/// A texture inside the model's file: a whole image file, or bare texels in the order b, g, r, a.
Result<Image<Rgba8>> decode_embedded(const aiTexture& texture, const std::string& name) {
  if (texture.pcData == nullptr) return Error{"it is empty"};
  if (texture.mHeight == 0) {
    return decode_image(
        std::as_bytes(std::span(reinterpret_cast<const char*>(texture.pcData), texture.mWidth)), name);
  }
  const int width = static_cast<int>(std::min(texture.mWidth, 1u << 30));
  const int height = static_cast<int>(std::min(texture.mHeight, 1u << 30));
  if (!reasonable_size(width, height)) return Error{"its size is absurd"};
  Image<Rgba8> image(width, height);
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    const aiTexel& texel = texture.pcData[i];
    image.pixels()[i] = {texel.r, texel.g, texel.b, texel.a};
  }
  return image;
}

Result<Image<Rgba8>> load_texture(const aiScene& scene, const std::filesystem::path& model_path,
                                  const std::string& name) {
  if (const aiTexture* embedded = scene.GetEmbeddedTexture(name.c_str()))
    return decode_embedded(*embedded, name);
  const auto path = find_beside_model(model_path.parent_path(), name);
  if (!path) return Error{"no such file"};
  return read_image(*path);
}

/// The texture of this name: one that is there already, or else a new one.
int texture_named(const std::string& name, const aiScene& scene, const std::filesystem::path& path,
                  Model& model) {
  const auto known = std::find_if(model.textures.begin(), model.textures.end(),
                                  [&](const ModelTexture& texture) { return texture.name == name; });
  if (known != model.textures.end()) return static_cast<int>(known - model.textures.begin());

  Result<Image<Rgba8>> image = load_texture(scene, path, name);
  if (image) {
    model.textures.push_back({.name = name, .image = std::move(*image), .missing = false});
  } else {
    model.textures.push_back(missing_texture(name));
    model.warnings.push_back("texture " + quoted_path(name) + " of model " + quoted_path(path) +
                             " is replaced by a checker: " + image.error().message);
  }
  return static_cast<int>(model.textures.size()) - 1;
}

/// What only glTF files have, and what of it nobody will see.
void convert_gltf_extras(const aiMaterial& from, const aiScene& scene, const std::filesystem::path& path, Material& to, Model& model) {
  convert_metallic_roughness(from, to);
  aiString name;
  if (from.GetTexture(aiTextureType_NORMALS, 0, &name) == AI_SUCCESS && name.length > 0) to.normal_texture = texture_named(name.C_Str(), scene, path, model);
  if (const std::string ignored = not_honoured(from); !ignored.empty())
    model.warnings.push_back("material '" + to.name + "' of model " + quoted_path(path) + ": not honoured: " + ignored);
}

}  // namespace

void convert_materials(const aiScene& scene, const std::filesystem::path& path, ColourSpace colours,
                       Model& model) {
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    const aiMaterial& from = *scene.mMaterials[i];
    Material to = convert_material(from, colours);
    for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}) {
      aiString name;
      const bool has_texture =
          to.texture < 0 && from.GetTexture(type, 0, &name) == AI_SUCCESS && name.length > 0;
      if (has_texture) to.texture = texture_named(name.C_Str(), scene, path, model);
    }
    if (colours == ColourSpace::linear) convert_gltf_extras(from, scene, path, to, model);
    model.materials.push_back(std::move(to));
  }
}

}  // namespace tuberia
