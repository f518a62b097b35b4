#pragma once
// Textures as the whole pipeline reads them: one lookup a pixel.

#include <memory>
#include <vector>

#include "pipeline/programs/fixed_function.hpp"
#include "tests/support/render.hpp"

namespace tuberia::test {

/// What unit 0 reads at (s, t, r, q), one point of the base level a coordinate.
inline std::vector<Rgba32F> looked_up(const std::shared_ptr<const Texture>& texture, const Sampler& sampler, const std::vector<glm::vec4>& strq,
                                      const PipelineOptions& options) {
  const auto count = static_cast<float>(strq.size());
  std::vector<glm::vec4> places;
  for (std::size_t i = 0; i < strq.size(); ++i) places.push_back({(2 * static_cast<float>(i) + 1) / count - 1, 0, 0, 1});
  FixedFunctionUniforms uniforms;
  uniforms.units[0] = {.texture = texture, .sampler = sampler};
  uniforms.units[0].colour = replace_environment().colour, uniforms.units[0].alpha = replace_environment().alpha;
  PipelineState state;
  state.assembly.topology = Topology::points;
  state.depth = kDepthOff;
  Studio studio({.width = static_cast<int>(strq.size()), .height = 1, .colour = ColourFormat::rgba32f, .options = options});
  MeshView mesh{.clip_positions = places};
  mesh.unit_texcoords[0] = strq;
  studio.draw(mesh, fixed_function(uniforms), state);
  const Image<Rgba32F> image = studio.target().linear_image();
  return {image.pixels().begin(), image.pixels().end()};
}

/// The pixel at (4, 4) of a screen-filling triangle whose coordinate there is `at` and grows by dx and dy
/// (of whole textures) from pixel to pixel.
inline Rgba32F looked_up_with_steps(const std::shared_ptr<const Texture>& texture, const Sampler& sampler, glm::vec2 at, glm::vec2 dx, glm::vec2 dy,
                                    const PipelineOptions& options) {
  const auto texcoord = [&](float x_pixels, float y_pixels) { return at + (x_pixels - 4.5f) * dx + (y_pixels - 4.5f) * dy; };
  const std::vector<glm::vec4> places{{-1, 1, 0, 1}, {3, 1, 0, 1}, {-1, -3, 0, 1}};
  const std::vector<glm::vec2> texcoords{texcoord(0, 0), texcoord(16, 0), texcoord(0, 16)};
  Studio studio({.width = 8, .height = 8, .colour = ColourFormat::rgba32f, .options = options});
  studio.draw({.clip_positions = places, .texcoords = texcoords}, textured({.texture = texture, .sampler = sampler}));
  return studio.target().linear_image().at(4, 4);
}

}  // namespace tuberia::test
