#pragma once
// Meshes of scenes as what draws take.

#include "scene/mesh_view.hpp"

namespace tuberia::test {

/// Refers to the mesh, which must outlive the draw.
inline MeshView view_of(const tuberia::Mesh& mesh) { return mesh_view(mesh); }

}  // namespace tuberia::test
