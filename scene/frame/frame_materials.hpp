#pragma once
// The materials of a scene as fragment programs.

#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "pipeline/draw_call.hpp"
#include "pipeline/programs/surface.hpp"
#include "scene/description/scene_description.hpp"
#include "scene/frame/frame_meshes.hpp"
#include "scene/frame/frame_textures.hpp"

namespace tuberia {

/// By the names that the scene gives them.
using FrameTextures = std::map<std::string, FrameTexture, std::less<>>;

/// What the surfaces of a frame have in common.
struct FrameLight {
  std::vector<SurfaceLight> lights;
  glm::vec3 ambient{0};
  glm::vec3 eye{0, 0, 1};       // world space
  EnvironmentMap environment;   // what mirrors show; kind none: nothing
};

/// The names of all textures that a material needs.
std::vector<std::string> textures_of(const description::Material& material);

/// Sets a draw's program, and the lighting of its vertices where that is where it is lit. Error for a surface
/// that is lit at its vertices with what only fragments can have: other models than Lambert's, Phong's and
/// Blinn's, patterns, relief, mirrors, shadows, projections, more than four lights; of flat and dot-product
/// shading also textures.
Result<Nothing> set_material(DrawCall& draw, const FramePart& part, description::Shading shading, const FrameTextures& textures, const FrameLight& light);

}  // namespace tuberia
