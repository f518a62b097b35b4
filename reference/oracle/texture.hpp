#pragma once
// Textures of the oracle: one level, looked up one sample at a time.

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "reference/oracle/interval.hpp"

namespace tuberia::oracle {

using Colour = std::array<Interval, 4>;

enum class TexelFilter { nearest, bilinear };
enum class Wrap { repeat, clamp, mirror, border };

struct Sampler {
  TexelFilter texels = TexelFilter::bilinear;
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  glm::vec4 border{0};
};

struct Texture {
  int width = 0, height = 0;
  bool is_srgb = false;
  std::vector<std::array<std::uint8_t, 4>> texels;  // row 0 on top
};

/// The colour at (u, v), bounded.
Colour sample(const Texture&, const Sampler&, Interval u, Interval v);

}  // namespace tuberia::oracle
