#pragma once
// The lights of a frame with what stands in their way, and what they throw.

#include <span>

#include "base/result.hpp"
#include "pipeline/pipeline.hpp"
#include "pipeline/programs/surface.hpp"
#include "scene/bounds.hpp"
#include "scene/description/scene_description.hpp"
#include "scene/frame/frame_materials.hpp"

namespace tuberia {

/// The points of a light; with a map of what they see if it casts shadows, and its picture if it throws one.
/// casters: draws of what may stand in its way. seen: a box around the whole scene, world space.
/// Errors: of draw_shadow_map, and a projection whose `up` lies along its axis.
Result<std::vector<SurfaceLight>> lights_with_shadows(Pipeline& pipeline, const description::Light& light, std::span<const DrawCall> casters,
                                                      const Bounds& seen, const FrameTextures& textures);

}  // namespace tuberia
