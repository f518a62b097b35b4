#pragma once
// The scenes that must come out the same from every machine, compiler, tile size and number of
// threads. Meshes have no indices: a vertex's number then names its primitive.

#include <string>
#include <vector>

#include "raster/render_target.hpp"
#include "tests/support/mesh.hpp"

namespace tuberia::determinism {

/// A draw that owns its mesh.
struct Layer {
  test::Mesh mesh{};                           // its positions, or else one of the next two
  std::vector<glm::vec4> clip_positions{};
  std::vector<ScreenVertex> screen_positions{};
  FragmentProgram program{};
  PipelineState state{};

  MeshView view() const {
    MeshView all = mesh.view();
    all.clip_positions = clip_positions;
    all.screen_positions = screen_positions;
    return all;
  }
};

struct Scene {
  std::string name{};  // without blanks
  RenderTargetDescription target{};
  float far_depth = 1;  // what depths are cleared to
  std::vector<Layer> layers{};
};

/// The layer as it is, and once more over it with every fragment added to the colours, so that no
/// bit of what is hidden stays unseen.
inline std::vector<Layer> seen_and_summed(const Layer& layer) {
  Layer summed = layer;
  summed.state.depth = kDepthOff;
  summed.state.blend.mode = BlendMode::additive;
  return {layer, summed};
}

/// All of them, in the order of the pinned file.
std::vector<Scene> scenes();

// Their parts.
std::vector<Scene> coverage_scenes();
std::vector<Scene> clipping_scenes();
std::vector<Scene> texture_scenes();
std::vector<Scene> output_scenes();

}  // namespace tuberia::determinism
