#include "scene/convert_assimp.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "math/colour.hpp"
#include "scene/mesh_repair.hpp"

namespace tuberia {
namespace {

glm::mat4 glm_from_assimp(const aiMatrix4x4& m) {
  return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

bool is_finite(const aiVector3D& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string not_finite(std::size_t vertex, const aiMesh& mesh) {
  return "vertex " + std::to_string(vertex) + " of mesh '" + mesh.mName.C_Str() +
         "' has a position that is not finite";
}

std::string why_not_mesh(const aiMesh& mesh) {
  if (mesh.mNumVertices > 0 && mesh.mVertices == nullptr)
    return std::string("mesh '") + mesh.mName.C_Str() + "' has no positions";
  for (unsigned vertex = 0; vertex < mesh.mNumVertices; ++vertex) {
    if (!is_finite(mesh.mVertices[vertex])) return not_finite(vertex, mesh);
  }
  for (unsigned face = 0; face < mesh.mNumFaces; ++face) {
    // Assimp's triangulation would fail an assertion.
    if (mesh.mFaces[face].mNumIndices == 0) {
      return "face " + std::to_string(face) + " of mesh '" + mesh.mName.C_Str() + "' has no corners";
    }
    for (unsigned corner = 0; corner < mesh.mFaces[face].mNumIndices; ++corner) {
      const unsigned index = mesh.mFaces[face].mIndices[corner];
      if (index < mesh.mNumVertices) continue;
      return "face " + std::to_string(face) + " of mesh '" + mesh.mName.C_Str() + "' has index " +
             std::to_string(index) + ", but the mesh has " + std::to_string(mesh.mNumVertices) +
             " vertices";
    }
  }
  return {};
}

/// What the conversion of one mesh left out or mended.
struct Losses {
  std::int64_t points_and_lines = 0;
  std::int64_t bad_normals = 0, bad_texcoords = 0, bad_colours = 0;
};

/// Directions across the surface turn with the cofactors of the transform, which exist even where
/// its inverse does not; a mirror turns them round once more.
glm::mat3 normal_transform(const glm::mat3& transform, float determinant) {
  const glm::mat3 cofactors(glm::cross(transform[1], transform[2]),
                            glm::cross(transform[2], transform[0]),
                            glm::cross(transform[0], transform[1]));
  return determinant < 0.0f ? -cofactors : cofactors;
}

/// The file's normals; smooth ones where the file has none, or one that is no direction, which is
/// common at triangles without an area.
void convert_normals(const aiMesh& from, const glm::mat3& transform, Mesh& to, Losses& losses) {
  std::vector<glm::vec3> normals(from.HasNormals() ? from.mNumVertices : 0u);
  std::vector<std::size_t> bad;
  for (std::size_t vertex = 0; vertex < normals.size(); ++vertex) {
    const aiVector3D& n = from.mNormals[vertex];
    const glm::vec3 turned = transform * glm::vec3(n.x, n.y, n.z);
    // Scaled first, so that neither large nor small components leave the range when squared.
    const float largest = std::max({std::abs(turned.x), std::abs(turned.y), std::abs(turned.z)});
    const bool good = largest > 0.0f && is_finite(turned);
    if (good) normals[vertex] = glm::normalize(turned / largest);
    if (!good) bad.push_back(vertex);
  }

  if (normals.empty() || !bad.empty()) make_smooth_normals(to);
  losses.bad_normals += static_cast<std::int64_t>(bad.size());
  for (const std::size_t vertex : bad) normals[vertex] = to.normals[vertex];
  if (!normals.empty()) to.normals = std::move(normals);
}

void convert_texcoords(const aiMesh& from, unsigned channel, Mesh& to, Losses& losses) {
  to.texcoords.reserve(from.mNumVertices);
  for (unsigned vertex = 0; vertex < from.mNumVertices; ++vertex) {
    const aiVector3D& uv = from.mTextureCoords[channel][vertex];
    const bool good = std::isfinite(uv.x) && std::isfinite(uv.y);
    to.texcoords.push_back(good ? glm::vec2(uv.x, uv.y) : glm::vec2(0));
    losses.bad_texcoords += good ? 0 : 1;
  }
}

void convert_colours(const aiMesh& from, ColourSpace space, Mesh& to, Losses& losses) {
  const auto linear = [&](float value) {
    const float clamped = value > 0.0f ? std::min(value, 1.0f) : 0.0f;  // NaN compares false
    return space == ColourSpace::linear ? clamped : static_cast<float>(linear_from_srgb(clamped));
  };
  to.colours.reserve(from.mNumVertices);
  for (unsigned vertex = 0; vertex < from.mNumVertices; ++vertex) {
    const aiColor4D& c = from.mColors[0][vertex];
    if (!std::isfinite(c.r + c.g + c.b + c.a)) ++losses.bad_colours;
    to.colours.emplace_back(linear(c.r), linear(c.g), linear(c.b),
                            c.a >= 0.0f ? std::min(c.a, 1.0f) : 1.0f);
  }
}

/// Which set of texture coordinates the material's texture uses, if the mesh has it.
unsigned texcoord_channel(const aiScene& scene, const aiMesh& mesh) {
  int channel = 0;
  scene.mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_UVWSRC(aiTextureType_DIFFUSE, 0), channel);
  return channel >= 0 && mesh.HasTextureCoords(static_cast<unsigned>(channel))
             ? static_cast<unsigned>(channel)
             : 0u;
}

/// Three indices a triangle; a mirror turns triangles round, so that their fronts stay outside.
void convert_faces(const aiMesh& from, bool mirrored, Mesh& to, Losses& losses) {
  to.indices.reserve(std::size_t{3} * from.mNumFaces);
  for (unsigned face = 0; face < from.mNumFaces; ++face) {
    const aiFace& corners = from.mFaces[face];
    if (corners.mNumIndices != 3) {
      ++losses.points_and_lines;
      continue;
    }
    const unsigned second = mirrored ? 2 : 1;
    to.indices.insert(to.indices.end(),
                      {corners.mIndices[0], corners.mIndices[second], corners.mIndices[3 - second]});
  }
}

Mesh convert_mesh(const aiScene& scene, const aiMesh& from, const glm::mat4& root_from_node,
                  ColourSpace colours, Losses& losses) {
  Mesh to;
  to.name = from.mName.C_Str();
  to.material = static_cast<int>(from.mMaterialIndex);
  const glm::mat3 linear_part(root_from_node);
  const float determinant = glm::determinant(linear_part);
  convert_faces(from, determinant < 0.0f, to, losses);
  if (to.indices.empty()) return to;

  to.positions.reserve(from.mNumVertices);
  for (unsigned vertex = 0; vertex < from.mNumVertices; ++vertex) {
    const aiVector3D& p = from.mVertices[vertex];
    to.positions.emplace_back(root_from_node * glm::vec4(p.x, p.y, p.z, 1.0f));
  }
  const unsigned channel = texcoord_channel(scene, from);
  if (from.HasTextureCoords(channel)) convert_texcoords(from, channel, to, losses);
  if (from.HasVertexColors(0)) convert_colours(from, colours, to, losses);
  convert_normals(from, normal_transform(linear_part, determinant), to, losses);
  return to;
}

void warn(const Losses& losses, Model& model) {
  const auto say = [&](std::int64_t count, const char* what) {
    if (count > 0) model.warnings.push_back(std::to_string(count) + what);
  };
  say(losses.points_and_lines, " points and lines were left out: only triangles are drawn");
  say(losses.bad_normals, " normals had no direction: smooth ones replace them");
  say(losses.bad_texcoords, " texture coordinates were not finite: 0 replaces them");
  say(losses.bad_colours, " vertex colours were not finite: 0 replaces them");
}

}  // namespace

std::string why_not_scene(const aiScene& scene) {
  if (scene.mRootNode == nullptr) return "it has no scene";
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    if (scene.mMeshes[i]->mMaterialIndex >= scene.mNumMaterials) {
      return std::string("mesh '") + scene.mMeshes[i]->mName.C_Str() +
             "' refers to a material that is not there";
    }
    if (std::string reason = why_not_mesh(*scene.mMeshes[i]); !reason.empty()) return reason;
  }
  return {};
}

std::string convert_meshes(const aiScene& scene, ColourSpace colours, Model& model) {
  Losses losses;
  std::vector<std::pair<const aiNode*, glm::mat4>> waiting;
  waiting.emplace_back(scene.mRootNode, glm::mat4(1.0f));
  while (!waiting.empty()) {
    const auto [node, root_from_parent] = waiting.back();
    waiting.pop_back();
    const glm::mat4 root_from_node = root_from_parent * glm_from_assimp(node->mTransformation);
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      if (node->mMeshes[i] >= scene.mNumMeshes) continue;
      const aiMesh& from = *scene.mMeshes[node->mMeshes[i]];
      Mesh mesh = convert_mesh(scene, from, root_from_node, colours, losses);
      if (mesh.indices.empty()) continue;
      for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        if (!is_finite(mesh.positions[vertex])) return not_finite(vertex, from);
      }
      join_identical_vertices(mesh);
      model.meshes.push_back(std::move(mesh));
    }
    // Last in, first out: the children in reverse keep the file's order.
    for (unsigned i = node->mNumChildren; i-- > 0;)
      waiting.emplace_back(node->mChildren[i], root_from_node);
  }
  warn(losses, model);
  return {};
}

}  // namespace tuberia
