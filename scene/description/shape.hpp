#pragma once
// What objects are made of: shapes in object space, y up, around the origin unless said otherwise.

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <variant>
#include <vector>

namespace tuberia::description {

/// Into how many parts curved surfaces are cut where triangles stand for them, along u and along v.
struct Segments {
  int u = 0, v = 0;
  bool operator==(const Segments&) const = default;
};

/// In the plane y = 0, facing +y.
struct Plane {
  double width = 2, depth = 2;  // along x and z
  Segments segments{1, 1};
  bool operator==(const Plane&) const = default;
};
struct Cube {
  glm::dvec3 size{2, 2, 2};
  int segments = 1;             // along each edge
  bool operator==(const Cube&) const = default;
};
struct Sphere {
  double radius = 1;
  Segments segments{64, 32};
  bool operator==(const Sphere&) const = default;
};
/// Its axis is y, from -height / 2 to height / 2.
struct Cylinder {
  double radius = 1, height = 2;
  bool capped = true;
  Segments segments{64, 1};
  bool operator==(const Cylinder&) const = default;
};
/// Its base lies at y = -height / 2, its tip at height / 2.
struct Cone {
  double radius = 1, height = 2;
  bool capped = true;
  Segments segments{64, 8};
  bool operator==(const Cone&) const = default;
};
/// Around the y axis.
struct Torus {
  double ring_radius = 1, tube_radius = 0.4;  // the first is the larger
  Segments segments{96, 48};
  bool operator==(const Torus&) const = default;
};
/// In the plane y = 0, facing +y.
struct Disc {
  double radius = 1;
  Segments segments{64, 8};
  bool operator==(const Disc&) const = default;
};
/// Newell's, resting on y = 0, from its published patches.
struct Teapot {
  double size = 1;              // times the size of its control points, with which its height is 3.15
  int segments = 10;            // along each edge of each patch
  bool operator==(const Teapot&) const = default;
};
/// Bicubic: 16 control points each, row by row; u runs along a row, v from row to row, and the outside is where
/// u runs to the right and v down.
struct BezierPatches {
  std::vector<std::array<glm::dvec3, 16>> patches;
  int segments = 16;            // along each edge of each patch
  bool operator==(const BezierPatches&) const = default;
};
/// A grid over the plane y = 0: heights row by row from -z to +z, or the red of a texture.
struct HeightField {
  double width = 2, depth = 2;                    // along x and z
  double height = 1;                              // heights are multiplied with it
  std::vector<std::vector<double>> heights;       // at least 2 rows of at least 2, all as long
  std::string texture;                            // "": the heights above
  bool operator==(const HeightField&) const = default;
};
/// Triangles in so many words. Counter-clockwise seen from their front.
struct TriangleMesh {
  std::vector<glm::dvec3> positions, normals;     // normals: none, or one for each position
  std::vector<glm::dvec2> texcoords;              // none, or one for each position; (0, 0) is the upper left of the image
  std::vector<glm::vec3> colours;                 // none, or one for each position; times kd, linear RGB
  std::vector<std::uint32_t> indices;             // three for each triangle
  bool operator==(const TriangleMesh&) const = default;
};
/// A file that load_model() reads.
struct ModelFile {
  std::string file;                               // relative to the scene's folder
  bool own_materials = true;                      // those of the file, or the object's one for all
  bool unit_size = false;                         // moved and scaled into the unit sphere around the origin
  bool operator==(const ModelFile&) const = default;
};

/// All of the plane y = 0, facing +y. Texture coordinates are x and z.
struct InfinitePlane {
  bool operator==(const InfinitePlane&) const = default;
};
/// Flat, counter-clockwise seen from its front; its holes are as flat, in its plane, either way round.
struct Polygon {
  std::vector<glm::dvec3> outline;                // at least 3 corners, in one plane
  std::vector<std::vector<glm::dvec3>> holes;
  bool operator==(const Polygon&) const = default;
};
/// What is inside of all planes (n, d): n.p + d <= 0. Normals of any length but 0.
struct Polyhedron {
  std::vector<glm::dvec4> planes;
  bool operator==(const Polyhedron&) const = default;
};
/// The points with (p, 1).q (p, 1) = 0 within a box; it is negative inside.
struct Quadric {
  glm::dmat4 q{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1};  // symmetric; unless said, the unit sphere
  glm::dvec3 lower{-1}, upper{1};
  bool operator==(const Quadric&) const = default;
};

using Shape = std::variant<Plane, Cube, Sphere, Cylinder, Cone, Torus, Disc, Teapot, BezierPatches, HeightField, TriangleMesh, ModelFile,
                           InfinitePlane, Polygon, Polyhedron, Quadric>;

}  // namespace tuberia::description
