#pragma once
// Meshes of scenes as what draws take.

#include "pipeline/draw_call.hpp"
#include "scene/mesh.hpp"

namespace tuberia::test {

/// Refers to the mesh, which must outlive the draw.
inline MeshView view_of(const tuberia::Mesh& mesh) {
  MeshView view;
  view.positions = mesh.positions;
  view.normals = mesh.normals;
  view.texcoords = mesh.texcoords;
  view.colours = mesh.colours;
  view.tangents = mesh.tangents;
  view.bitangents = mesh.bitangents;
  view.indices = mesh.indices;
  return view;
}

}  // namespace tuberia::test
