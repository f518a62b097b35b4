#pragma once
// The first of the two passes: a scene's depths as a light sees them.                       [A 1.3]

#include <span>

#include "base/result.hpp"
#include "pipeline/pipeline.hpp"
#include "pipeline/programs/shadow_map.hpp"
#include "scene/shadows/light_view.hpp"

namespace tuberia {

struct ShadowPass {
  int size = 1024;                         // texels each way, 1..RenderTarget::kMaxSize
  DepthFormat format = DepthFormat::d32f;  // how exactly depths are kept; the map is of floats whatever it is
  CullFace cull = CullFace::none;          // front: only what is turned away from the light is drawn, so that lit sides need no bias
  PolygonOffset offset{};                  // pushes the casters away instead of moving what is compared with them
  bool operator==(const ShadowPass&) const = default;
};

/// Draws the scene's own draws, without colours, from the light: their meshes, matrices, topologies and
/// windings, and the program and alpha test of those that drop fragments; no other state. What does not write
/// depth casts no shadow. The map's biases and taps are its defaults, its constant bias what rounding asks
/// for. Error for a mesh that is not in object space, naming the draw, and of RenderTarget and Pipeline::draw.
Result<ShadowMap> draw_shadow_map(Pipeline& pipeline, std::span<const DrawCall> casters, const LightView& light, const ShadowPass& pass = {});

/// The same for a light that looks all around: six passes, each pass.size texels each way. Error for a size
/// beyond Texture::kMaxCubeSize, too.
Result<ShadowMap> draw_shadow_map(Pipeline& pipeline, std::span<const DrawCall> casters, const LightCube& light, const ShadowPass& pass = {});

/// The same for any light and a box (world space) of all that casts and receives: one picture, or six where a
/// point light does not see the whole box in one.
Result<ShadowMap> draw_shadow_map(Pipeline& pipeline, std::span<const DrawCall> casters, const Light& light, const Bounds& seen, const ShadowPass& pass = {});

}  // namespace tuberia
