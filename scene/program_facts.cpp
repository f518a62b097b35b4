#include "scene/program_facts.hpp"

#include <algorithm>
#include <utility>

namespace tuberia {
namespace {

bool is_same(const FragmentProgram& a, const FragmentProgram& b) { return &a.interface() == &b.interface(); }

const TexturedUniforms& textured_uniforms(const FragmentProgram& program) { return *static_cast<const TexturedUniforms*>(program.uniforms()); }
const TexturedLitUniforms& lit_uniforms(const FragmentProgram& program) { return *static_cast<const TexturedLitUniforms*>(program.uniforms()); }

bool is_cut_out(const FragmentProgram& program) { return program.interface().may_discard; }

/// Whether all codes of all levels lie under a mask of bits that are set.
bool all_codes_have(const Texture& texture, std::uint32_t bits) {
  for (const TextureLevel& level : texture.levels()) {
    if (level.texels == nullptr) return false;
    const auto count = static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height) * static_cast<std::size_t>(level.slices);
    if (!std::all_of(level.texels, level.texels + count, [bits](std::uint32_t code) { return (code & bits) == bits; })) return false;
  }
  return true;
}

bool reads_border(const Sampler& sampler) {
  return sampler.wrap_u == Wrap::border || sampler.wrap_v == Wrap::border || sampler.wrap_w == Wrap::border;
}

bool is_opaque(const std::shared_ptr<const Texture>& texture, const Sampler& sampler) {
  return texture && texture->format() == TextureFormat::rgba8 && !reads_border(sampler) && all_codes_have(*texture, 0xff000000u);
}

bool is_white(const TextureUnit& unit) {
  return unit.texture->format() == TextureFormat::rgba8 && !reads_border(unit.sampler) && all_codes_have(*unit.texture, 0xffffffffu);
}

/// What came before, as it is. (Units before have clamped it to [0, 1], and so has the primary colour.)
bool passes_on(const Combine& combine, bool texel_is_one) {
  const auto is = [&](std::size_t i, CombineSource source) {
    return combine.argument[i].source == source && combine.argument[i].operand == CombineOperand::colour;
  };
  if (combine.scale != 1) return false;
  if (combine.function == CombineFunction::replace) return is(0, CombineSource::previous);
  if (combine.function != CombineFunction::modulate || !texel_is_one) return false;
  return (is(0, CombineSource::texture) && is(1, CombineSource::previous)) || (is(0, CombineSource::previous) && is(1, CombineSource::texture));
}

bool has_alpha_one(std::span<const glm::vec4> colours) {
  return std::all_of(colours.begin(), colours.end(), [](const glm::vec4& c) { return c.a == 1; });
}

bool is_one_colour(std::span<const glm::vec4> colours) {
  return std::all_of(colours.begin(), colours.end(), [&](const glm::vec4& c) { return c == colours.front(); });
}

}  // namespace

ProgramKind kind_of(const FragmentProgram& program) {
  static const std::pair<FragmentProgram, ProgramKind> kKnown[] = {
      {flat(), ProgramKind::flat},
      {gouraud(), ProgramKind::gouraud},
      {phong({}), ProgramKind::phong},
      {textured({}), ProgramKind::textured},
      {textured({}, true), ProgramKind::textured},
      {textured_gouraud({}), ProgramKind::textured_gouraud},
      {textured_lit({}), ProgramKind::textured_lit},
      {textured_lit({}, true), ProgramKind::textured_lit}};
  for (const auto& [known, kind] : kKnown)
    if (is_same(program, known)) return kind;
  return program.interface().name.starts_with("fixed_function_") ? ProgramKind::fixed_function : ProgramKind::other;
}

bool has_opaque_vertices(const DrawCall& draw) {
  const TransformState& transform = draw.state.transform;
  const auto is_lit_opaquely = [](const std::optional<Lighting>& lighting) { return !lighting || lighting->alpha == 1; };
  if (!is_lit_opaquely(transform.vertex_lighting) || !has_alpha_one(draw.mesh.colours)) return false;
  return !transform.two_sided_colours || (is_lit_opaquely(transform.back_lighting) && has_alpha_one(draw.mesh.back_colours));
}

bool has_one_vertex_colour(const DrawCall& draw) {
  const TransformState& transform = draw.state.transform;
  return !transform.vertex_lighting && !transform.two_sided_colours && is_one_colour(draw.mesh.colours);
}

bool is_opaque(const DrawCall& draw, int samples) {
  const bool has_opaque_colours = (samples == 1 || draw.state.rasterization.flat_shading) && has_opaque_vertices(draw);
  switch (kind_of(draw.program)) {
    case ProgramKind::flat: return has_opaque_vertices(draw);
    case ProgramKind::gouraud: return has_opaque_colours;
    case ProgramKind::phong: return static_cast<const Lighting*>(draw.program.uniforms())->alpha == 1;
    case ProgramKind::textured: {
      const TexturedUniforms& u = textured_uniforms(draw.program);
      return u.tint.a == 1 && is_opaque(u.texture, u.sampler);
    }
    case ProgramKind::textured_gouraud: {
      const TexturedUniforms& u = textured_uniforms(draw.program);
      return has_opaque_colours && is_opaque(u.texture, u.sampler);
    }
    case ProgramKind::textured_lit: {
      const TexturedLitUniforms& u = lit_uniforms(draw.program);
      return u.tint.a == 1 && u.lighting.alpha == 1 && is_opaque(u.texture, u.sampler);
    }
    case ProgramKind::fixed_function:
      return draw.program.interface().name == "fixed_function_0" && has_opaque_colours;
    case ProgramKind::other: break;
  }
  return false;
}

const char* reason_to_drop_nothing(const DrawCall& draw) {
  const ProgramKind kind = kind_of(draw.program);
  if (!is_cut_out(draw.program) || (kind != ProgramKind::textured && kind != ProgramKind::textured_lit)) return nullptr;
  const bool is_lit = kind == ProgramKind::textured_lit;
  const std::shared_ptr<const Texture>& texture = is_lit ? lit_uniforms(draw.program).texture : textured_uniforms(draw.program).texture;
  const Sampler& sampler = is_lit ? lit_uniforms(draw.program).sampler : textured_uniforms(draw.program).sampler;
  const float tint = is_lit ? lit_uniforms(draw.program).tint.a : textured_uniforms(draw.program).tint.a;
  const float cutoff = is_lit ? lit_uniforms(draw.program).alpha_cutoff : textured_uniforms(draw.program).alpha_cutoff;
  if (cutoff <= 0 && tint >= 0 && texture->format() == TextureFormat::rgba8 && !reads_border(sampler))
    return "no alpha is below the cutoff of 0";
  if (cutoff <= 1 && tint == 1 && is_opaque(texture, sampler)) return "every texel is opaque";
  return nullptr;
}

UnitsInUse remove_idle_units(FragmentProgram& program) {
  UnitsInUse count;
  if (kind_of(program) != ProgramKind::fixed_function || program.interface().name == "fixed_function_0") return count;
  FixedFunctionUniforms uniforms = *static_cast<const FixedFunctionUniforms*>(program.uniforms());
  for (TextureUnit& unit : uniforms.units) {
    if (!unit.texture) continue;
    ++count.on;
    const bool texel_is_one = is_white(unit);
    if (passes_on(unit.colour, texel_is_one) && passes_on(unit.alpha, texel_is_one)) unit.texture = nullptr;
    else ++count.in_use;
  }
  if (count.in_use < count.on) program = fixed_function(std::move(uniforms));
  return count;
}

FragmentProgram without_cut_out(const FragmentProgram& program) {
  return kind_of(program) == ProgramKind::textured ? textured(textured_uniforms(program)) : textured_lit(lit_uniforms(program));
}

}  // namespace tuberia
