#include "raster/sampler.hpp"

#include <cmath>
#include <cstdio>

namespace tuberia {

namespace {

/// The text lasts until the next one on this thread.
template <class... Values>
const char* sentence(const char* format, Values... values) noexcept {
  static thread_local char text[120];
  std::snprintf(text, sizeof text, format, static_cast<double>(values)...);
  return text;
}

bool is_known(const Sampler& s) noexcept {
  for (const Wrap wrap : {s.wrap_u, s.wrap_v, s.wrap_w})
    if (wrap > Wrap::border) return false;
  if (s.weights > FilterWeights::eight_bits || s.footprint > Footprint::ellipse) return false;
  return s.texels <= TexelFilter::bilinear && s.mipmaps <= MipmapFilter::linear && (!s.compare || *s.compare <= Compare::always);
}

}  // namespace

const char* refusal_of(const Sampler& sampler) noexcept {
  const auto& [r, g, b, a] = sampler.border;
  if (!is_known(sampler)) return "a filter, wrap, comparison, weight or footprint of the sampler is none of its enumeration";
  if (!(sampler.max_anisotropy >= 1 && sampler.max_anisotropy <= 16))
    return sentence("the sampler's max_anisotropy is %g, outside 1 to 16", sampler.max_anisotropy);
  if (!std::isfinite(sampler.lod_bias)) return sentence("the sampler's lod_bias is %g; it must be finite", sampler.lod_bias);
  if (!(sampler.min_lod <= sampler.max_lod))
    return sentence("the sampler's min_lod is %g and its max_lod %g, which is no range", sampler.min_lod, sampler.max_lod);
  if (!std::isfinite(r) || !std::isfinite(g) || !std::isfinite(b) || !std::isfinite(a))
    return sentence("the sampler's border is (%g, %g, %g, %g); it must be finite", r, g, b, a);
  return nullptr;
}

}  // namespace tuberia
