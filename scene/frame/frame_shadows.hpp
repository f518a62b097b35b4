#pragma once
// The lights of a frame with what stands in their way, and what they throw.

#include <span>
#include <variant>

#include "base/result.hpp"
#include "pipeline/pipeline.hpp"
#include "pipeline/programs/surface.hpp"
#include "scene/bounds.hpp"
#include "scene/description/scene_description.hpp"
#include "scene/frame/frame_materials.hpp"
#include "scene/shadows/light_view.hpp"

namespace tuberia {

/// Where the map of a light's shadows is drawn from: one view, or all around.
using ShadowView = std::variant<LightView, LightCube>;

/// point: one of the light's. seen: a box around the whole scene, world space. Spots see what is in their cone only.
/// Errors: of light_view and light_cube.
Result<ShadowView> shadow_view_of(const description::Light& light, const Light& point, const Bounds& seen);

/// The points of a light; with a map of what they see if it casts shadows, and its picture if it throws one.
/// casters: draws of what may stand in its way. seen: a box around the whole scene, world space.
/// Errors: of draw_shadow_map, and a projection whose `up` lies along its axis.
Result<std::vector<SurfaceLight>> lights_with_shadows(Pipeline& pipeline, const description::Light& light, std::span<const DrawCall> casters,
                                                      const Bounds& seen, const FrameTextures& textures);

}  // namespace tuberia
