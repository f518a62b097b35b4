#pragma once
// Assimp's scene into ours; only files that know Assimp include this.

#include <filesystem>
#include <string>

#include <assimp/scene.h>

#include "scene/model.hpp"

namespace tuberia {

/// Which numbers a format stores for colours.
enum class ColourSpace { linear, srgb };

/// What is wrong with a scene fresh from Assimp: no root, an index or a material out of range, a
/// position that is not finite; empty if nothing. Look before any of Assimp's own steps works on the scene.
std::string why_not_scene(const aiScene& scene);

/// Appends all meshes of all nodes, transformed to the space of the root, and a warning for what
/// had to be left out or mended. Returns what is wrong, empty if nothing: a position that is not
/// finite after its transform.
std::string convert_meshes(const aiScene& scene, ColourSpace colours, Model& model);

/// What glTF alone says of a material.
void convert_metallic_roughness(const aiMaterial& from, Material& to);

/// What a material has that ours cannot have, for a warning: "an occlusion texture, a clear coat"; empty if nothing.
std::string not_honoured(const aiMaterial& from);

/// Appends all materials, in the scene's order, with their textures. path: of the model's file.
void convert_materials(const aiScene& scene, const std::filesystem::path& path, ColourSpace colours,
                       Model& model);

}  // namespace tuberia
