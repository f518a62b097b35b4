#pragma once
// A draw while it is examined: internal to scene/requirements.

#include <string>

#include "scene/clip_bounds.hpp"
#include "scene/requirements.hpp"

namespace tuberia {

struct Examination {
  const RenderTargetDescription& target;
  DrawCall& smallest;       // so far
  Requirements& found;
  const ClipBounds& bounds;

  /// What a feature is needed for, or why it is not.
  void say(Feature feature, bool is_needed, bool was_on, std::string reason) {
    found.features[static_cast<std::size_t>(feature)] = {feature, is_needed, was_on, std::move(reason)};
  }
};

// What follows the vertices; before the geometry is examined, since it may not need what the vertices carry.
void examine_fragments(Examination& e);
void examine_program(Examination& e);
void examine_geometry(Examination& e);
void examine_vertices(Examination& e);

}  // namespace tuberia
