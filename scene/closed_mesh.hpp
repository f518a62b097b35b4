#pragma once
// Whether a mesh has an inside.

#include "pipeline/draw_call.hpp"

namespace tuberia {

/// Whether triangles of a list meet at every edge, one for each direction of it, so that the mesh is entered
/// as often as it is left: then its back faces are hidden by its front faces, where these are opaque and the eye is
/// outside. Vertices at the same object-space position count as one. False without triangles, or for other topologies.
bool is_closed(const DrawCall& draw);

}  // namespace tuberia
