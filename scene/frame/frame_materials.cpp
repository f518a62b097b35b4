#include "scene/frame/frame_materials.hpp"

#include <algorithm>
#include <array>

#include "pipeline/programs/programs.hpp"
#include "scene/content/material_constants.hpp"

namespace tuberia {
namespace {

using description::Shading;

BumpMap bump_of(const description::Bump& from, const FrameTextures& textures) {
  constexpr std::array kKinds{BumpMap::Kind::height_texture, BumpMap::Kind::normal_map, BumpMap::Kind::waves, BumpMap::Kind::orange, BumpMap::Kind::rough};
  BumpMap bump{.kind = kKinds[static_cast<std::size_t>(from.kind)], .texture = nullptr, .sampler = {}, .gain = static_cast<float>(from.gain),
               .scale = static_cast<float>(from.scale), .seed = from.seed};
  if (const auto found = textures.find(from.texture); found != textures.end()) {
    bump.texture = found->second.texture;
    bump.sampler = found->second.sampler;
  }
  return bump;
}

SurfaceColour colour_of(const FramePart& part, const FrameTextures& textures) {
  SurfaceColour colour;
  if (part.own_texture != nullptr) {
    colour.texture = part.own_texture;
  } else if (const auto found = textures.find(part.material.texture); found != textures.end()) {
    colour.texture = found->second.texture;
    colour.sampler = found->second.sampler;
    colour.access = found->second.access;
  } else if (part.material.pattern) {
    colour.pattern = pattern_of(*part.material.pattern);
  }
  return colour;
}

SurfaceUniforms uniforms_of(const FramePart& part, const FrameTextures& textures, const FrameLight& light) {
  const description::Material& material = part.material;
  SurfaceUniforms uniforms;
  uniforms.reflection = constants_of(material);
  uniforms.colour = colour_of(part, textures);
  if (material.bump) uniforms.bump = bump_of(*material.bump, textures);
  if (part.own_normals != nullptr) uniforms.bump.texture = part.own_normals;
  if (material.mirror != glm::vec3(0) && light.environment.kind != EnvironmentMap::Kind::none) {
    uniforms.environment = light.environment;
    uniforms.mirror = material.mirror;
  }
  uniforms.ambient_light = light.ambient;
  uniforms.lights = light.lights;
  uniforms.eye = light.eye;
  uniforms.two_sided = material.two_sided || material.transmission != glm::vec3(0);
  uniforms.alpha = static_cast<float>(material.alpha);
  return uniforms;
}

/// Why a surface cannot be lit at its vertices; empty if it can.
std::string what_needs_fragments(const FramePart& part, Shading shading, const FrameLight& light) {
  const description::Material& material = part.material;
  const bool is_plain = material.model == description::Reflection::lambert || material.model == description::Reflection::phong ||
                        material.model == description::Reflection::blinn_phong;
  const bool has_texture = !material.texture.empty() || part.own_texture != nullptr;
  const auto has_more = [](const SurfaceLight& one) { return one.shadow.has_value() || one.projected.has_value(); };
  if (!is_plain) return "this reflection model";
  if (material.pattern) return "a pattern";
  if (material.bump) return "a bump";
  if (material.mirror != glm::vec3(0)) return "a mirror";
  if (has_texture && shading != Shading::gouraud) return "a texture";
  if (std::any_of(light.lights.begin(), light.lights.end(), has_more)) return "a light with shadow or projection";
  if (light.lights.size() > Lighting::kMaxLights) return "more than " + std::to_string(Lighting::kMaxLights) + " lights (a light of an area is several)";
  if (light.lights.size() > 2 && shading == Shading::dot_product) return "more than 2 lights";
  return {};
}

Lighting lighting_of(const description::Material& material, const FrameLight& light) {
  const ReflectionConstants constants = constants_of(material);
  Lighting lighting{.ambient = constants.ambient * light.ambient, .diffuse = constants.diffuse, .specular = constants.specular, .shininess = constants.exponent,
                    .alpha = static_cast<float>(material.alpha), .halfway = material.model != description::Reflection::phong, .two_sided = material.two_sided || material.transmission != glm::vec3(0),
                    .eye = light.eye};
  lighting.light_count = static_cast<int>(light.lights.size());
  for (std::size_t i = 0; i < light.lights.size(); ++i) lighting.lights[i] = light.lights[i].light;
  return lighting;
}

}  // namespace

std::vector<std::string> textures_of(const description::Material& material) {
  std::vector<std::string> names;
  if (!material.texture.empty()) names.push_back(material.texture);
  if (material.bump && !material.bump->texture.empty()) names.push_back(material.bump->texture);
  return names;
}

Result<Nothing> set_material(DrawCall& draw, const FramePart& part, Shading shading, const FrameTextures& textures, const FrameLight& light) {
  if (shading == Shading::phong) {
    draw.program = surface(uniforms_of(part, textures, light));
    return Nothing{};
  }
  if (const std::string reason = what_needs_fragments(part, shading, light); !reason.empty()) return Error{reason + " goes with shading phong only"};
  const Lighting lighting = lighting_of(part.material, light);
  if (shading == Shading::dot_product) {
    draw.state.transform.vertex_cosines = lighting;
    draw.program = dot_product(lighting);
    return Nothing{};
  }
  draw.state.transform.vertex_lighting = lighting;
  const SurfaceColour colour = colour_of(part, textures);
  draw.program = shading == Shading::flat ? flat()
                 : colour.texture != nullptr ? textured_gouraud({.texture = colour.texture, .sampler = colour.sampler})
                                             : gouraud();
  return Nothing{};
}

}  // namespace tuberia
