#pragma once
// Materials of model files as those of scenes.

#include "scene/description/material.hpp"
#include "scene/material.hpp"

namespace tuberia {

/// A material of ours for one of a file; names no textures.
/// Usual materials: lambert, or blinn_phong where they have a highlight; ka is kd.
/// Those of glTF: cook_torrance as later derived (D/pi, 4), m = max(roughness^2, 0.02), which is glTF's own alpha; the
/// refractive index (1 + s) / (1 - s), s = sqrt(F0) up to 0.98, gives the reflectance F0 at normal incidence, which is
/// 0.04 of dielectrics, the base colour of metals, and mixed by `metallic` in between; ks = 1, kd = base (1 - metallic). A metal
/// has no kd, so that it would be black but for highlights: ka is the base colour for all, and
/// reflects_surroundings lets it mirror with kps = F0 (1 - roughness)^2.
description::Material description_of(const Material& material, bool reflects_surroundings = false);

}  // namespace tuberia
