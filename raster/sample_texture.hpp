#pragma once
// Reading textures without a pipeline, by the very kernels that fragment programs call.

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>

#include "raster/instruction_set.hpp"
#include "raster/sampler.hpp"
#include "raster/texture.hpp"

namespace tuberia {

/// One look at a texture. The coordinates are s, t, r; for a cube map a direction of any length. Those
/// that the texture has no use for are not read.
struct TextureLookup {
  glm::vec3 at{0};
  glm::vec3 dx{0}, dy{0};      // how much they change to the next pixel in x and in y
  std::optional<float> lod{};  // level of detail instead of dx and dy; bias and bounds still apply
  float reference = 0;         // what a depth texture's texels are compared with
  bool operator==(const TextureLookup&) const = default;
};

/// Linear intensities, one for each lookup; as many as fit in `colours`. Any float is safe anywhere:
/// numbers that are not finite read some texel, or the border. Any precision but fast counts as exact. [rules T2]
void sample_texture(const Texture& texture, const Sampler& sampler, std::span<const TextureLookup> lookups,
                    std::span<Rgba32F> colours, InstructionSet instruction_set = best_instruction_set(),
                    Precision precision = Precision::exact);

Rgba32F sample_texture(const Texture& texture, const Sampler& sampler, const TextureLookup& lookup);

}  // namespace tuberia
