#pragma once
// Only what the scene requires: what a draw needs of the pipeline, why, and the smallest pipeline that
// draws the same picture.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/draw_call.hpp"
#include "raster/render_target.hpp"

namespace tuberia {

/// What a pipeline may do for a draw, in its order.
enum class Feature : std::uint8_t {
  drawing,              // anything at all
  vertex_attributes,    // beside positions
  vertex_lighting,
  two_sided_colours,
  clipping,
  user_planes,
  culling,
  polygon_modes,        // edges and corners instead of insides
  polygon_offset,
  scissor,
  multisampling,
  shading,              // colours at all: not in a depth-only pass
  interpolation,        // over the triangle; else one colour each
  perspective,          // correction of what is interpolated
  textures,
  late_depth_test,      // after the program, because something may drop fragments
  fog,
  alpha_test,
  alpha_to_coverage,
  stencil,
  depth_test,
  depth_write,
  blending,
  colour_mask,
  counting,             // of fragments, for queries
};
inline constexpr int kFeatures = static_cast<int>(Feature::counting) + 1;

std::string_view name_of(Feature) noexcept;

struct Requirement {
  Feature feature;
  bool is_needed = false;
  bool was_on = false;     // the draw asked for it; if it is not needed, the smallest pipeline does without
  std::string reason;      // a sentence
};

struct Requirements {
  std::vector<Requirement> features;           // all, in the order of the pipeline
  Attributes attributes = Attributes::none;    // of the vertices, that the smallest pipeline reads
  DrawCall smallest;                           // refers to the draw's own arrays
  bool needs(Feature feature) const noexcept { return features[static_cast<std::size_t>(feature)].is_needed; }
  const Requirement& operator[](Feature feature) const noexcept { return features[static_cast<std::size_t>(feature)]; }
};

/// Examines a draw that validate() accepts for such a target. Looks at each position and colour once: worth
/// it for what is drawn more than once. In exact precision the smallest pipeline leaves the same bits of
/// colour, depth and stencil. A draw of which nothing can be seen needs no `drawing`.
Requirements requirements_of(const DrawCall& draw, const RenderTargetDescription& target);

/// Of draws in their order, those that can be seen, each with its smallest pipeline.
std::vector<DrawCall> smallest_pipelines(std::span<const DrawCall> draws, const RenderTargetDescription& target);

/// The attributes of a set by name, "position, normal"; "nothing" for none.
std::string words_of(Attributes attributes);

}  // namespace tuberia
