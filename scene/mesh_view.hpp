#pragma once
// A mesh as the pipeline takes it.

#include "pipeline/draw_call.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// Refers to the mesh, which must outlive the draw.
inline MeshView mesh_view(const Mesh& mesh) {
  MeshView view;
  view.positions = mesh.positions;
  view.normals = mesh.normals;
  view.texcoords = mesh.texcoords;
  view.colours = mesh.colours;
  view.indices = mesh.indices;
  view.tangents = mesh.tangents;
  view.bitangents = mesh.bitangents;
  return view;
}

}  // namespace tuberia
