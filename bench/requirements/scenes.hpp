#pragma once
// Scenes that each need something else of the pipeline: made by formulas, no files.

#include <memory>
#include <string>
#include <vector>

#include "bench/peers/meshes.hpp"
#include "pipeline/draw_call.hpp"
#include "raster/render_target.hpp"

namespace tuberia::bench {

/// The arrays that draws refer to.
struct SceneArrays {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> texcoords;
  std::vector<glm::vec4> colours;
  std::vector<std::uint32_t> indices;
};

struct RequirementScene {
  std::string name, caption;
  RenderTargetDescription target{.width = 1280, .height = 720, .stencil = true};
  std::vector<std::unique_ptr<SceneArrays>> arrays{};
  std::vector<DrawCall> draws{};
};

std::vector<std::string> requirement_scene_names();

/// name: one of the above.
RequirementScene make_requirement_scene(const std::string& name);

}  // namespace tuberia::bench
