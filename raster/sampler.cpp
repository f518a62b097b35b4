#include "raster/sampler.hpp"

#include <cmath>

namespace tuberia {

const char* refusal_of(const Sampler& sampler) noexcept {
  const Rgba32F& border = sampler.border;
  if (!(sampler.max_anisotropy >= 1 && sampler.max_anisotropy <= 16)) return "the sampler's max_anisotropy is outside 1..16";
  if (!std::isfinite(sampler.lod_bias)) return "the sampler's lod_bias is not finite";
  if (!(sampler.min_lod <= sampler.max_lod)) return "the sampler's min_lod is above its max_lod";
  if (!std::isfinite(border.r) || !std::isfinite(border.g) || !std::isfinite(border.b) || !std::isfinite(border.a))
    return "the sampler's border colour is not finite";
  return nullptr;
}

}  // namespace tuberia
