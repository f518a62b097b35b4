#pragma once
// What a surface does with light, as far as the fixed-function pipeline can show it.

#include <optional>
#include <string>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace tuberia {

/// How glTF describes a surface. What it comes to in a reflection model of ours: description_of().
struct MetallicRoughness {
  float metallic = 1;   // 0: a dielectric, 1: a metal, whose base colour is that of its highlight
  float roughness = 1;  // 0: a mirror, 1: quite dull
  bool operator==(const MetallicRoughness&) const = default;
};

/// Reflectances are linear, in [0, 1]. load_model() takes the numbers of glTF as linear, as that
/// format says, and decodes those of all other formats (OBJ, 3DS, Collada, ...) as sRGB signals,
/// which is how people choose them on a screen.
struct Material {
  std::string name{};
  glm::vec4 base_colour{1.0f};  // diffuse reflectance and opacity; multiplies the texture
  glm::vec3 ambient{0.0f};
  glm::vec3 specular{0.0f};
  float shininess = 0.0f;     // exponent of the highlight, 0 or more; 0: no highlight
  int texture = -1;           // into Model::textures; sRGB codes; -1: none
  bool two_sided = false;     // the back is seen too
  float alpha_cutoff = 0.0f;  // fragments of less alpha are not drawn; 0: all are
  std::optional<MetallicRoughness> metallic_roughness{};  // of glTF files
  int normal_texture = -1;    // into Model::textures; linear codes of a normal map; -1: none
  float normal_scale = 1.0f;  // how much of its relief

  bool operator==(const Material&) const = default;
};

}  // namespace tuberia
