#include "scene/requirements.hpp"

#include <array>

#include "scene/examination.hpp"
#include "scene/program_facts.hpp"

namespace tuberia {
namespace {

constexpr std::array<std::string_view, kFeatures> kNames{
    "drawing", "vertex attributes", "vertex lighting", "two-sided colours", "clipping", "user planes", "culling", "polygon modes",
    "polygon offset", "scissor", "multisampling", "shading", "interpolation", "perspective", "textures", "late depth test", "fog",
    "alpha test", "alpha to coverage", "stencil", "depth test", "depth write", "blending", "colour mask", "counting"};

Viewport viewport_of(const DrawCall& draw, const RenderTargetDescription& target) {
  return draw.state.viewport.viewport.value_or(Viewport{0, 0, target.width, target.height});
}

PixelRect open_pixels(const DrawCall& draw, const RenderTargetDescription& target) {
  const Viewport v = viewport_of(draw, target);
  const PixelRect open = intersection({0, 0, target.width, target.height}, {v.x, v.y, v.x + v.width_pixels, v.y + v.height_pixels});
  return draw.state.rasterization.scissor ? intersection(open, *draw.state.rasterization.scissor) : open;
}

bool is_outside_a_user_plane(const DrawCall& draw, const ClipBounds& bounds) {
  if (!bounds.are_known()) return false;
  for (int k = 0; k < draw.state.clipping.user_plane_count; ++k)
    if (bounds.range_of(draw.state.clipping.user_planes[static_cast<std::size_t>(k)]).highest < 0) return true;
  return false;
}

bool stores_nothing(const DrawCall& draw) {
  const PipelineState& state = draw.state;
  const ColourMask& mask = state.blend.mask;
  const bool stores_colour = state.blend.write && (mask.red || mask.green || mask.blue || mask.alpha);
  return !stores_colour && !state.depth.write && !state.stencil.enabled && !draw.count_fragments;
}

/// Why nothing of the draw can be seen; null if something may be.
const char* reason_to_draw_nothing(const DrawCall& draw, const RenderTargetDescription& target, const ClipBounds& bounds) {
  const bool only_insides = makes_triangles(draw.state.assembly.topology) && draw.state.rasterization.front_mode == PolygonMode::fill &&
                            draw.state.rasterization.back_mode == PolygonMode::fill;
  if (draw.mesh.element_count() == 0) return "The mesh has no vertices.";
  if (open_pixels(draw, target).empty()) return "Viewport and scissor leave no pixel of the target.";
  if (bounds.are_outside(!only_insides)) return "All vertices lie beyond the same plane of the view volume.";
  if (is_outside_a_user_plane(draw, bounds)) return "All vertices lie outside the same user plane.";
  if (draw.state.alpha_test.test == Compare::never) return "The alpha test never passes.";
  if (stores_nothing(draw)) return "Neither colour nor depth nor stencil is stored, and nothing is counted.";
  return nullptr;
}

}  // namespace

std::string_view name_of(Feature feature) noexcept { return kNames[static_cast<std::size_t>(feature)]; }

std::string words_of(Attributes attributes) {
  constexpr std::array<const char*, kAttributeScalars.size()> kWords{"position", "normal", "texture coordinates", "colour", "custom",
                                                                     "unit 0", "unit 1", "unit 2", "unit 3", "tangent", "bitangent"};
  std::string words;
  for (std::size_t i = 0; i < kWords.size(); ++i)
    if (contains(attributes, static_cast<Attributes>(1u << i))) words += (words.empty() ? "" : ", ") + std::string(kWords[i]);
  return words.empty() ? "nothing" : words;
}

Requirements requirements_of(const DrawCall& draw, const RenderTargetDescription& target) {
  Requirements found;
  found.smallest = draw;
  for (int i = 0; i < kFeatures; ++i) found.features.push_back({static_cast<Feature>(i), false, false, {}});
  const ClipBounds bounds(draw, viewport_of(draw, target));
  Examination examination{target, found.smallest, found, bounds};
  const char* nothing = reason_to_draw_nothing(draw, target, bounds);
  examination.say(Feature::drawing, nothing == nullptr, true, nothing != nullptr ? nothing : "Some of it may be seen.");
  examine_fragments(examination);
  examine_program(examination);
  examine_geometry(examination);
  examine_vertices(examination);
  return found;
}

std::vector<DrawCall> smallest_pipelines(std::span<const DrawCall> draws, const RenderTargetDescription& target) {
  std::vector<DrawCall> smallest;
  for (const DrawCall& draw : draws) {
    Requirements requirements = requirements_of(draw, target);
    if (requirements.needs(Feature::drawing)) smallest.push_back(std::move(requirements.smallest));
  }
  return smallest;
}

}  // namespace tuberia
