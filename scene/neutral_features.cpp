#include "scene/neutral_features.hpp"

#include "scene/program_facts.hpp"

namespace tuberia {
namespace {

constexpr Feature kNeutral[] = {Feature::two_sided_colours, Feature::user_planes, Feature::scissor, Feature::textures, Feature::late_depth_test,
                                Feature::fog, Feature::alpha_test, Feature::alpha_to_coverage, Feature::stencil, Feature::blending};

/// Both sides with the same colours.
bool add_two_sides(DrawCall& draw) {
  TransformState& transform = draw.state.transform;
  if (transform.two_sided_colours || transform.vertex_lighting || transform.back_lighting || !draw.mesh.back_colours.empty()) return false;
  if (!makes_triangles(draw.state.assembly.topology)) return false;
  if (!contains(draw.program.interface().attributes(), Attributes::colour)) return false;
  return transform.two_sided_colours = true;
}

/// A plane of zeros has every point on it.
bool add_user_plane(DrawCall& draw) {
  ClippingState& clipping = draw.state.clipping;
  if (clipping.user_plane_count == ClippingState::kMaxUserPlanes || !draw.mesh.screen_positions.empty()) return false;
  clipping.user_planes[static_cast<std::size_t>(clipping.user_plane_count++)] = glm::dvec4(0);
  return true;
}

bool add_scissor(DrawCall& draw, const RenderTargetDescription& target) {
  if (draw.state.rasterization.scissor) return false;
  draw.state.rasterization.scissor = PixelRect{0, 0, target.width, target.height};
  return true;
}

std::shared_ptr<const Texture> white_texture() {
  static const auto kTexture = std::make_shared<const Texture>(*Texture::create(Image<Rgba8>(64, 64, {255, 255, 255, 255}), TextureEncoding::linear));
  return kTexture;
}

/// A texture unit that reads a white texture with trilinear filtering and multiplies the colour by it. It clamps
/// the colour before fog is mixed in, and not after.
bool add_texture_unit(DrawCall& draw) {
  const ProgramKind kind = kind_of(draw.program);
  if ((kind != ProgramKind::flat && kind != ProgramKind::gouraud) || draw.state.fog.mode != FogMode::off) return false;
  if (draw.mesh.texcoords.empty()) {
    if (!draw.mesh.screen_positions.empty() || !draw.mesh.clip_positions.empty()) return false;
    TexCoordUnit& unit = draw.state.transform.texture_units[0];
    unit.source = {TexCoordSource::object_linear, TexCoordSource::object_linear, TexCoordSource::object_linear, TexCoordSource::object_linear};
    unit.plane = {glm::vec4(1, 0, 0, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, 1, 0), glm::vec4(0, 0, 0, 1)};
  }
  if (kind == ProgramKind::flat) draw.state.rasterization.flat_shading = true;
  FixedFunctionUniforms uniforms;
  uniforms.units[0].texture = white_texture();
  draw.program = fixed_function(std::move(uniforms));
  return true;
}

/// A program that may drop fragments, and drops none.
bool add_cut_out(DrawCall& draw) {
  if (draw.program.interface().may_discard) return false;
  const ProgramKind kind = kind_of(draw.program);
  DrawCall changed = draw;
  if (kind == ProgramKind::textured) {
    TexturedUniforms uniforms = *static_cast<const TexturedUniforms*>(draw.program.uniforms());
    uniforms.alpha_cutoff = 0;
    changed.program = textured(std::move(uniforms), true);
  } else if (kind == ProgramKind::textured_lit) {
    TexturedLitUniforms uniforms = *static_cast<const TexturedLitUniforms*>(draw.program.uniforms());
    uniforms.alpha_cutoff = 0;
    changed.program = textured_lit(std::move(uniforms), true);
  } else {
    return false;
  }
  if (reason_to_drop_nothing(changed) == nullptr) return false;
  draw = changed;
  return true;
}

/// Fog of density 0: all light comes through. Black, since (C - 0) + 0 is C to the last bit.
bool add_fog(DrawCall& draw, const RenderTargetDescription& target) {
  if (draw.state.fog.mode != FogMode::off || !draw.state.blend.write || target.samples > 1) return false;
  draw.state.fog = {.mode = FogMode::exp2, .colour = {0, 0, 0, 0}, .density = 0};
  return true;
}

bool add_alpha_test(DrawCall& draw) {
  if (draw.state.alpha_test.test != Compare::always) return false;
  draw.state.alpha_test = {.test = Compare::greater_equal, .reference = 0};
  return true;
}

bool add_alpha_to_coverage(DrawCall& draw, const RenderTargetDescription& target) {
  if (draw.state.multisampling.alpha_to_coverage || !is_opaque(draw, target.samples)) return false;
  return draw.state.multisampling.alpha_to_coverage = true;
}

bool add_stencil(DrawCall& draw, const RenderTargetDescription& target) {
  if (draw.state.stencil.enabled || !target.stencil) return false;
  draw.state.stencil = {.enabled = true};
  return true;
}

/// The same blending, written as factors.
bool add_blend_function(DrawCall& draw) {
  using enum BlendFactor;
  BlendState& blend = draw.state.blend;
  if (!blend.write || blend.logic != LogicOperation::off) return false;
  switch (blend.mode) {
    case BlendMode::function: return false;
    case BlendMode::replace: blend.colour = blend.alpha = {one, zero}; break;
    case BlendMode::additive: blend.colour = blend.alpha = {one, one}; break;
    case BlendMode::source_over:
      blend.colour = {source_alpha, one_minus_source_alpha};
      blend.alpha = {one, one_minus_source_alpha};
  }
  blend.mode = BlendMode::function;
  return true;
}

bool add(DrawCall& draw, Feature feature, const RenderTargetDescription& target) {
  switch (feature) {
    case Feature::two_sided_colours: return add_two_sides(draw);
    case Feature::user_planes: return add_user_plane(draw);
    case Feature::scissor: return add_scissor(draw, target);
    case Feature::textures: return add_texture_unit(draw);
    case Feature::late_depth_test: return add_cut_out(draw);
    case Feature::fog: return add_fog(draw, target);
    case Feature::alpha_test: return add_alpha_test(draw);
    case Feature::alpha_to_coverage: return add_alpha_to_coverage(draw, target);
    case Feature::stencil: return add_stencil(draw, target);
    case Feature::blending: return add_blend_function(draw);
    default: return false;
  }
}

}  // namespace

std::span<const Feature> neutral_features() noexcept { return kNeutral; }

std::optional<DrawCall> with_neutral(const DrawCall& draw, Feature feature, const RenderTargetDescription& target) {
  DrawCall changed = draw;
  if (!has_codes(target.colour) || !add(changed, feature, target)) return std::nullopt;
  return changed;
}

DrawCall with_everything(const DrawCall& draw, const RenderTargetDescription& target) {
  DrawCall changed = draw;
  for (const Feature feature : kNeutral)
    if (auto more = with_neutral(changed, feature, target)) changed = *std::move(more);
  return changed;
}

}  // namespace tuberia
