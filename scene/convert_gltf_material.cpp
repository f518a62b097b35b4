#include <algorithm>
#include <array>
#include <cstring>

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>

#include "scene/convert_assimp.hpp"

namespace tuberia {
namespace {

/// A texture that a material of ours has no place for.
struct UnknownTexture {
  aiTextureType type;
  unsigned index;
  const char* words;
};
constexpr std::array<UnknownTexture, 10> kUnknownTextures{{
    {aiTextureType_UNKNOWN, 0, "a metallic-roughness texture"},
    {aiTextureType_LIGHTMAP, 0, "an occlusion texture"},
    {aiTextureType_EMISSIVE, 0, "an emissive texture"},
    {aiTextureType_SPECULAR, 0, "a specular texture"},
    {aiTextureType_SHEEN, 0, "a sheen texture"},
    {aiTextureType_CLEARCOAT, 0, "a clear coat texture"},
    {aiTextureType_CLEARCOAT, 1, "a texture of the clear coat's roughness"},
    {aiTextureType_CLEARCOAT, 2, "a clear coat's normal texture"},
    {aiTextureType_TRANSMISSION, 0, "a transmission texture"},
    {aiTextureType_BASE_COLOR, 1, "a second base colour texture"},
}};

void add(std::string& list, const char* words) {
  if (!list.empty()) list += ", ";
  list += words;
}

/// Which of the file's sets of texture coordinates a texture is looked up with.
bool has_other_coordinates(const aiMaterial& material, aiTextureType type) {
  int set = 0;
  return material.Get(AI_MATKEY_UVWSRC(type, 0), set) == AI_SUCCESS && set != 0;
}

}  // namespace

void convert_metallic_roughness(const aiMaterial& from, Material& to) {
  float metallic = 1, roughness = 1, scale = 1;
  const bool has_metallic = from.Get(AI_MATKEY_METALLIC_FACTOR, metallic) == AI_SUCCESS;
  const bool has_roughness = from.Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness) == AI_SUCCESS;
  const auto unit = [](float value) { return value >= 0 ? std::min(value, 1.0f) : 0.0f; };
  if (has_metallic || has_roughness) to.metallic_roughness = MetallicRoughness{.metallic = unit(metallic), .roughness = unit(roughness)};
  if (from.Get(AI_MATKEY_GLTF_TEXTURE_SCALE(aiTextureType_NORMALS, 0), scale) == AI_SUCCESS) to.normal_scale = std::clamp(scale, -1e6f, 1e6f);
}

std::string not_honoured(const aiMaterial& from) {
  std::string list;
  for (const UnknownTexture& texture : kUnknownTextures) {
    aiString name;
    if (from.GetTexture(texture.type, texture.index, &name) == AI_SUCCESS && name.length > 0) add(list, texture.words);
  }
  aiColor3D emissive;
  if (from.Get(AI_MATKEY_COLOR_EMISSIVE, emissive) == AI_SUCCESS && (emissive.r > 0 || emissive.g > 0 || emissive.b > 0)) add(list, "light of its own");
  float factor = 0;
  if (from.Get(AI_MATKEY_CLEARCOAT_FACTOR, factor) == AI_SUCCESS && factor > 0) add(list, "a clear coat");
  if (from.Get(AI_MATKEY_TRANSMISSION_FACTOR, factor) == AI_SUCCESS && factor > 0) add(list, "transmission");
  aiColor3D sheen;
  if (from.Get(AI_MATKEY_SHEEN_COLOR_FACTOR, sheen) == AI_SUCCESS && (sheen.r > 0 || sheen.g > 0 || sheen.b > 0)) add(list, "a sheen");
  if (has_other_coordinates(from, aiTextureType_BASE_COLOR)) add(list, "a second set of texture coordinates for the colour");
  if (has_other_coordinates(from, aiTextureType_NORMALS)) add(list, "a second set of texture coordinates for the normals");
  return list;
}

}  // namespace tuberia
