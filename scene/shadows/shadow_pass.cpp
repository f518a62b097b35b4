#include "scene/shadows/shadow_pass.hpp"

#include <algorithm>
#include <string>

#include "pipeline/programs/programs.hpp"
#include "raster/texture_target.hpp"

namespace tuberia {
namespace {

bool may_drop_fragments(const DrawCall& draw) {
  return draw.program.is_set() && (draw.program.interface().may_discard || draw.state.alpha_test.test != Compare::always);
}

/// The draw as a light needs it: nothing but depths.
DrawCall depth_only(const DrawCall& draw, const LightView& light, const ShadowPass& pass) {
  DrawCall drawn{.mesh = draw.mesh, .program = flat(), .state = {}};
  if (may_drop_fragments(draw)) {
    drawn.program = draw.program;
    drawn.state.transform = draw.state.transform;
    drawn.state.alpha_test = draw.state.alpha_test;
  }
  drawn.state.transform.world_from_object = draw.state.transform.world_from_object;
  drawn.state.transform.clip_from_world = light.clip_from_world;
  drawn.state.assembly = draw.state.assembly;
  drawn.state.clipping.volume = light.camera.clip_volume;
  drawn.state.culling = {.front_face = draw.state.culling.front_face, .cull = pass.cull};
  drawn.state.rasterization.polygon_offset = pass.offset;
  drawn.state.blend.write = false;
  return drawn;
}

/// What two roundings of one depth may differ by.
float depth_error_of(DepthFormat format) { return format == DepthFormat::d16 ? 0x1p-15f : 0x1p-22f; }

/// The depths of the casters in a light's view.
Result<Image<float>> draw_depths(Pipeline& pipeline, std::span<const DrawCall> casters, const LightView& light, const ShadowPass& pass) {
  auto target = RenderTarget::create(pass.size, pass.size, ColourFormat::rgba8, pass.format);
  if (!target) return Error{"shadow map: " + target.error().message};
  for (std::size_t i = 0; i < casters.size(); ++i) {
    if (!casters[i].state.depth.write) continue;
    const std::string name = "shadow map, draw " + std::to_string(i) + ": ";
    if (!casters[i].mesh.clip_positions.empty() || !casters[i].mesh.screen_positions.empty())
      return Error{name + "its mesh is given in clip or screen space, where no light can see it"};
    if (const auto drawn = pipeline.draw(*target, depth_only(casters[i], light, pass)); !drawn) return Error{name + drawn.error().message};
  }
  return target->depth_image();
}

/// A camera's picture as the face of a cube map.
Image<float> mirrored_depths(const Image<float>& image) {
  Image<float> result(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y) std::reverse_copy(image.row(y).begin(), image.row(y).end(), result.row(y).begin());
  return result;
}

}  // namespace

Result<ShadowMap> draw_shadow_map(Pipeline& pipeline, std::span<const DrawCall> casters, const LightView& light, const ShadowPass& pass) {
  const auto image = draw_depths(pipeline, casters, light, pass);
  if (!image) return image.error();
  auto depths = Texture::create_depth(*image);
  if (!depths) return Error{"shadow map: " + depths.error().message};
  const auto texels = static_cast<float>(pass.size);
  return ShadowMap{.depths = std::make_shared<const Texture>(*std::move(depths)), .map_from_world = light.map_from_world,
                   .texel_right = light.right / texels, .texel_down = light.down / texels,
                   .depth_error = depth_error_of(pass.format), .constant_bias = light.position_error};
}

Result<ShadowMap> draw_shadow_map(Pipeline& pipeline, std::span<const DrawCall> casters, const LightCube& light, const ShadowPass& pass) {
  auto depths = Texture::create_empty({.kind = TextureKind::cube, .format = TextureFormat::depth32f, .width = pass.size, .height = pass.size, .with_mipmaps = false});
  if (!depths) return Error{"shadow map: " + depths.error().message};
  ShadowMap map;
  map.map_from_world = translation(-light.position);
  map.depth_error = depth_error_of(pass.format);
  for (int face = 0; face < 6; ++face) {
    const auto view = light_view(light, face);
    if (!view) return view.error();
    const auto image = draw_depths(pipeline, casters, *view, pass);
    if (!image) return image.error();
    if (const auto replaced = depths->replace(0, face, mirrored_depths(*image)); !replaced) return Error{"shadow map: " + replaced.error().message};
    map.constant_bias = view->position_error;
  }
  const double depth_range = light.far_distance - light.near_distance;
  map.cube_depth = glm::vec2(light.far_distance / depth_range, -light.far_distance * light.near_distance / depth_range);
  map.depths = std::make_shared<const Texture>(*std::move(depths));
  return map;
}

Result<ShadowMap> draw_shadow_map(Pipeline& pipeline, std::span<const DrawCall> casters, const Light& light, const Bounds& seen, const ShadowPass& pass) {
  const auto view = light_view(light, seen);
  if (view) return draw_shadow_map(pipeline, casters, *view, pass);
  const auto cube = light.kind == Light::Kind::directional ? Result<LightCube>(view.error()) : light_cube(light, seen);
  if (!cube) return cube.error();
  return draw_shadow_map(pipeline, casters, *cube, pass);
}

}  // namespace tuberia
