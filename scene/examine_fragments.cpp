// What happens to fragments: which of it can change a pixel.

#include <cmath>
#include <string>

#include "scene/examination.hpp"
#include "scene/program_facts.hpp"

namespace tuberia {
namespace {

bool passes(float alpha, Compare test, float reference) {
  switch (test) {
    case Compare::less: return alpha < reference;
    case Compare::less_equal: return alpha <= reference;
    case Compare::equal: return alpha == reference;
    case Compare::greater: return alpha > reference;
    case Compare::greater_equal: return alpha >= reference;
    case Compare::not_equal: return alpha != reference;
    case Compare::always: return true;
    case Compare::never: break;
  }
  return false;
}

void examine_alpha(Examination& e) {
  PipelineState& state = e.smallest.state;
  const bool opaque = is_opaque(e.smallest, e.target.samples);
  const AlphaTest test = state.alpha_test;
  const bool asked = test.test != Compare::always;
  const bool by_range = (test.test == Compare::greater_equal && test.reference <= 0) || (test.test == Compare::less_equal && test.reference >= 1);
  const bool passes_all = by_range || (opaque && passes(1, test.test, test.reference));
  if (!asked) e.say(Feature::alpha_test, false, false, "Alpha drops no fragment.");
  else if (passes_all) e.say(Feature::alpha_test, false, true, by_range ? "Every alpha in [0, 1] passes it." : "Every fragment has alpha 1, which passes it.");
  else e.say(Feature::alpha_test, true, true, "Fragments may fail it.");
  if (passes_all) state.alpha_test = {};

  const bool to_coverage = state.multisampling.alpha_to_coverage;
  e.say(Feature::alpha_to_coverage, to_coverage && !opaque, to_coverage,
        !to_coverage ? "Alpha chooses no samples." : opaque ? "Every fragment has alpha 1 and keeps all samples." : "Alpha may drop samples.");
  if (opaque) state.multisampling.alpha_to_coverage = false;
}

void examine_late_depth(Examination& e) {
  const char* drops_nothing = reason_to_drop_nothing(e.smallest);
  const bool could_discard = e.smallest.program.interface().may_discard, discards = could_discard && drops_nothing == nullptr;
  const bool by_alpha = e.found.needs(Feature::alpha_test) || e.found.needs(Feature::alpha_to_coverage);
  const bool was_on = could_discard || e.found[Feature::alpha_test].was_on || e.found[Feature::alpha_to_coverage].was_on;
  if (drops_nothing != nullptr) e.smallest.program = without_cut_out(e.smallest.program);
  e.say(Feature::late_depth_test, discards || by_alpha, was_on,
        discards                   ? "The program may drop fragments, which must leave no depth."
        : by_alpha                 ? "Alpha may drop fragments, which must leave no depth."
        : drops_nothing != nullptr ? "The program could drop fragments, but " + std::string(drops_nothing) + "."
                                   : "Nothing drops a shaded fragment: depth comes first, and what is hidden is not shaded.");
}

/// Whether anything of a colour is stored, and whether a program must run at all.
void examine_shading(Examination& e) {
  BlendState& blend = e.smallest.state.blend;
  const ColourMask& mask = blend.mask;
  const bool stores = blend.write && (mask.red || mask.green || mask.blue || mask.alpha);
  const bool drops = e.found.needs(Feature::late_depth_test);
  e.say(Feature::shading, stores || drops, blend.write || drops,
        stores  ? "Colours are stored."
        : drops ? "No colour is stored, but alpha decides about depth."
                : "No colour is stored: a depth-only pass.");
  e.say(Feature::colour_mask, stores && !mask.all(), blend.write && !mask.all(),
        mask.all() ? "All channels are stored." : stores ? "Some channels keep their codes." : "No channel is stored at all.");
  if (!stores) blend = {.write = false};
  if (!stores && !drops) e.smallest.program = flat();
}

/// The largest fog coordinate that a vertex can have; infinite if that is not known.
float largest_fog_coordinate(const Examination& e) {
  double largest = 0;
  if (!e.smallest.mesh.fog_coordinates.empty()) {
    for (const float c : e.smallest.mesh.fog_coordinates) largest = std::fmax(largest, std::abs(static_cast<double>(c)));
  } else {
    if (!e.bounds.are_known()) return INFINITY;
    const ClipRange w = e.bounds.range_of({0, 0, 0, 1});
    largest = std::fmax(std::abs(w.lowest), std::abs(w.highest));
  }
  constexpr double kRoundings = 1 + 0x1p-16;  // of its interpolation
  return static_cast<float>(largest * kRoundings);
}

void examine_fog(Examination& e) {
  FogState& fog = e.smallest.state.fog;
  if (fog.mode == FogMode::off) return e.say(Feature::fog, false, false, "There is none.");
  const bool thin = fog.mode == FogMode::linear ? fog.start < fog.end && largest_fog_coordinate(e) <= fog.start : fog.density == 0;
  const bool black = fog.colour.r == 0 && fog.colour.g == 0 && fog.colour.b == 0;
  if (!e.smallest.state.blend.write) e.say(Feature::fog, false, true, "No colour is stored.");
  else if (!thin) e.say(Feature::fog, true, true, "Fragments may be in it.");
  else if (!black || !has_codes(e.target.colour) || e.target.samples > 1) e.say(Feature::fog, true, true, "It is nowhere, but mixing with its colour may round.");
  else e.say(Feature::fog, false, true, "It is so thin that every fragment keeps its colour.");
  if (!e.found.needs(Feature::fog)) fog = {};
}

bool leaves_stencil_alone(const StencilFace& f) {
  using enum StencilOperation;
  const bool keeps = f.write_mask == 0 || (f.fail == keep && f.depth_fail == keep && f.pass == keep);
  const bool compares_nothing = f.read_mask == 0 && (f.test == Compare::equal || f.test == Compare::less_equal || f.test == Compare::greater_equal);
  return keeps && (f.test == Compare::always || compares_nothing);
}

void examine_stencil(Examination& e) {
  StencilState& stencil = e.smallest.state.stencil;
  const bool idle = leaves_stencil_alone(stencil.front) && leaves_stencil_alone(stencil.back);
  e.say(Feature::stencil, stencil.enabled && !idle, stencil.enabled,
        !stencil.enabled ? "There is no stencil test." : idle ? "It always passes and keeps every code." : "It may fail, or changes codes.");
  if (idle) stencil = {};
}

void examine_depth(Examination& e) {
  const DepthState& depth = e.smallest.state.depth;
  const bool tests = depth.test != Compare::always;
  e.say(Feature::depth_test, tests, tests, tests ? "What is behind stored depths must not be drawn." : "Nearness does not matter.");
  e.say(Feature::depth_write, depth.write, depth.write, depth.write ? "Later fragments are compared with these depths." : "Depths stay as they are.");
}

bool is_function(const BlendFunction& f, BlendFactor source, BlendFactor destination) {
  return f == BlendFunction{source, destination, BlendEquation::add};
}

/// The everyday mode that a function is, on formats whose codes both round alike.
BlendMode everyday_mode(const BlendState& blend) {
  using enum BlendFactor;
  if (is_function(blend.colour, one, zero) && is_function(blend.alpha, one, zero)) return BlendMode::replace;
  if (is_function(blend.colour, one, one) && is_function(blend.alpha, one, one)) return BlendMode::additive;
  if (is_function(blend.colour, source_alpha, one_minus_source_alpha) && is_function(blend.alpha, one, one_minus_source_alpha))
    return BlendMode::source_over;
  return BlendMode::function;
}

void examine_blending(Examination& e) {
  BlendState& blend = e.smallest.state.blend;
  const bool was_on = blend.write && (blend.mode != BlendMode::replace || blend.logic != LogicOperation::off);
  if (!was_on) return e.say(Feature::blending, false, false, "Colours replace those of their pixels.");
  if (blend.logic == LogicOperation::copy) {
    blend.logic = LogicOperation::off;
    blend.mode = BlendMode::replace;
  }
  if (blend.logic != LogicOperation::off) return e.say(Feature::blending, true, true, "A logic operation combines codes.");
  if (!has_codes(e.target.colour) && blend.mode != BlendMode::replace)
    return e.say(Feature::blending, true, true, "Floats keep every bit that blending makes.");
  if (blend.mode == BlendMode::function) blend.mode = everyday_mode(blend);
  const bool opaque = blend.mode == BlendMode::source_over && is_opaque(e.smallest, e.target.samples);
  if (opaque) blend.mode = BlendMode::replace;
  if (blend.mode != BlendMode::function) blend.colour = blend.alpha = {};
  e.say(Feature::blending, blend.mode != BlendMode::replace, true,
        opaque                                ? "Every fragment has alpha 1: all is opaque."
        : blend.mode == BlendMode::replace ? "Its factors are 1 and 0: colours replace those of their pixels."
                                              : "Pixels keep a part of what they had.");
}

}  // namespace

void examine_fragments(Examination& e) {
  examine_alpha(e);
  examine_late_depth(e);
  examine_shading(e);
  examine_fog(e);
  examine_stencil(e);
  examine_depth(e);
  examine_blending(e);
  const bool counts = e.smallest.count_fragments;
  e.say(Feature::counting, counts, counts, counts ? "The draw asks how many fragments it has." : "Nobody asks how many fragments there are.");
}

}  // namespace tuberia
