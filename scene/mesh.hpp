#pragma once
// Triangles that share a material.

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "scene/bounds.hpp"

namespace tuberia {

/// An indexed list of triangles, counter-clockwise seen from their front. Every attribute but the
/// positions is either empty or has one entry per position.
struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;    // object space
  std::vector<glm::vec3> normals;      // object space, length 1
  std::vector<glm::vec3> tangents;     // object space, dP/du: the change of position along one unit of texcoord u; not unit
  std::vector<glm::vec3> bitangents;   // object space, dP/dv; not unit
  std::vector<glm::vec2> texcoords;    // (0, 0) is the upper left corner of the image, v down
  std::vector<glm::vec4> colours;      // linear, in [0, 1]; alpha not premultiplied
  std::vector<std::uint32_t> indices;  // three a triangle, each less than positions.size()
  int material = 0;                    // into Model::materials

  std::int64_t triangle_count() const noexcept { return static_cast<std::int64_t>(indices.size() / 3); }
  bool operator==(const Mesh&) const = default;
};

/// Of all positions, whether an index uses them or not.
Bounds bounds(const Mesh& mesh) noexcept;

}  // namespace tuberia
