#include <algorithm>
#include <array>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include "scene/description/scene_keys.hpp"

namespace tuberia::description {
namespace {

using Rows = std::vector<std::vector<double>>;

/// In the order of the variant.
constexpr std::array<std::string_view, 16> kShapes{"plane", "cube", "sphere", "cylinder", "cone", "torus", "disc", "teapot", "bezier-patches", "height-field", "mesh", "model",
                                                   "infinite-plane", "polygon", "polyhedron", "quadric"};

void segments_key(Keys& keys, Segments& segments, Segments least) {
  std::array<double, 2> both{static_cast<double>(segments.u), static_cast<double>(segments.v)};
  keys.numbers({"segments", "parts along u and v, where triangles stand for the surface"}, both, within(1, 4096), true);
  segments = {static_cast<int>(both[0]), static_cast<int>(both[1])};
  keys.require("segments", segments.u == both[0] && segments.v == both[1], "is not of whole numbers");
  keys.require("segments", segments.u >= least.u && segments.v >= least.v, "is less than [" + std::to_string(least.u) + ", " + std::to_string(least.v) + "]");
}

void plane_keys(Keys& keys, Plane& plane) {
  keys.number({"width", "along x"}, plane.width, above(0));
  keys.number({"depth", "along z"}, plane.depth, above(0));
  segments_key(keys, plane.segments, {1, 1});
}

void cube_keys(Keys& keys, Cube& cube) {
  keys.numbers({"size", "along x, y and z"}, {&cube.size.x, 3}, above(0), true);
  keys.whole({"segments", "parts along each edge"}, cube.segments, 1, 1024);
}

void sphere_keys(Keys& keys, Sphere& sphere) {
  keys.number({"radius", ""}, sphere.radius, above(0));
  segments_key(keys, sphere.segments, {3, 2});
}

/// Cylinders and cones.
template <class Capped>
void capped_keys(Keys& keys, Capped& shape) {
  keys.number({"radius", "of its base"}, shape.radius, above(0));
  keys.number({"height", "along y, half of it below the origin"}, shape.height, above(0));
  keys.flag({"capped", "with its flat ends"}, shape.capped);
  segments_key(keys, shape.segments, {3, 1});
}

void torus_keys(Keys& keys, Torus& torus) {
  keys.number({"ring_radius", "of the circle that the tube's middle runs along"}, torus.ring_radius, above(0));
  keys.number({"tube_radius", "of the tube, smaller than the other"}, torus.tube_radius, above(0));
  keys.require("tube_radius", torus.tube_radius < torus.ring_radius, "is not smaller than ring_radius");
  segments_key(keys, torus.segments, {3, 3});
}

void disc_keys(Keys& keys, Disc& disc) {
  keys.number({"radius", ""}, disc.radius, above(0));
  segments_key(keys, disc.segments, {3, 1});
}

void teapot_keys(Keys& keys, Teapot& teapot) {
  keys.number({"size", "times the size of its published control points"}, teapot.size, above(0));
  keys.whole({"segments", "parts along each edge of each patch"}, teapot.segments, 1, 256);
}

template <class Vector>
Rows rows_of(const std::vector<Vector>& vectors) {
  Rows rows;
  for (const Vector& vector : vectors) {
    std::vector<double>& row = rows.emplace_back();
    for (int i = 0; i < Vector::length(); ++i) row.push_back(static_cast<double>(vector[i]));
  }
  return rows;
}

template <class Vector>
std::vector<Vector> vectors_of(const Rows& rows) {
  std::vector<Vector> vectors;
  for (const std::vector<double>& row : rows) {
    Vector& vector = vectors.emplace_back();
    for (int i = 0; i < Vector::length(); ++i) vector[i] = static_cast<typename Vector::value_type>(row[static_cast<std::size_t>(i)]);
  }
  return vectors;
}

template <class Vector>
void vectors_key(Keys& keys, const Key& key, std::vector<Vector>& vectors, const Range& range = {}) {
  Rows rows = rows_of(vectors);
  keys.rows(key, rows, static_cast<std::size_t>(Vector::length()), range);
  vectors = vectors_of<Vector>(rows);
}

void patch_keys(Keys& keys, std::array<glm::dvec3, 16>& patch) {
  std::vector<glm::dvec3> points(patch.begin(), patch.end());
  vectors_key(keys, {"points", "16 control points, 4 rows along v of 4 along u", true}, points);
  keys.require("points", points.size() == patch.size(), "is not of 16 points");
  std::copy_n(points.begin(), std::min(points.size(), patch.size()), patch.begin());
}

void bezier_keys(Keys& keys, BezierPatches& shape) {
  keys.list({"patches", "bicubic ones", true}, shape.patches, patch_keys);
  keys.whole({"segments", "parts along each edge of each patch"}, shape.segments, 1, 1024);
}

void height_field_keys(Keys& keys, HeightField& field) {
  keys.number({"width", "along x"}, field.width, above(0));
  keys.number({"depth", "along z"}, field.depth, above(0));
  keys.number({"height", "what heights are multiplied with"}, field.height);
  keys.rows({"heights", "from -z to +z, of each row from -x to +x"}, field.heights, 0, {});
  keys.name({"texture", "whose red is the height; one of `textures`"}, field.texture, NameOf::texture);
  keys.require("heights", field.heights.empty() || (field.heights.size() >= 2 && field.heights[0].size() >= 2), "is smaller than 2 rows of 2");
  keys.require("texture", field.heights.empty() || field.texture.empty(), "is there beside heights");
  keys.require("heights", !field.heights.empty() || !field.texture.empty(), "is missing, and there is no texture either");
}

/// Triangles are rows of three in the file.
void triangles_key(Keys& keys, TriangleMesh& mesh) {
  Rows rows;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) rows.push_back({double(mesh.indices[i]), double(mesh.indices[i + 1]), double(mesh.indices[i + 2])});
  keys.rows({"triangles", "three numbers of vertices each, from 0, counter-clockwise from their front", true}, rows, 3, at_least(0));
  mesh.indices.clear();
  for (const std::vector<double>& row : rows)
    for (const double index : row) {
      const bool is_vertex = index < static_cast<double>(mesh.positions.size()) && index == static_cast<double>(static_cast<std::int64_t>(index));
      if (!is_vertex) {
        keys.require("triangles", false, "has the index " + words_of(index) + ", but the mesh has " + std::to_string(mesh.positions.size()) + " vertices");
        return;
      }
      mesh.indices.push_back(static_cast<std::uint32_t>(index));
    }
}

void mesh_keys(Keys& keys, TriangleMesh& mesh) {
  vectors_key(keys, {"positions", "of its vertices", true}, mesh.positions);
  vectors_key(keys, {"normals", "one for each vertex, or none: then they are made"}, mesh.normals);
  vectors_key(keys, {"texcoords", "one for each vertex, or none; (0, 0) is the upper left of a picture"}, mesh.texcoords);
  vectors_key(keys, {"colours", "one for each vertex, or none; times `diffuse`"}, mesh.colours, at_least(0));
  const auto fits = [&](std::size_t count) { return count == 0 || count == mesh.positions.size(); };
  keys.require("normals", fits(mesh.normals.size()), "is not one for each position");
  keys.require("texcoords", fits(mesh.texcoords.size()), "is not one for each position");
  keys.require("colours", fits(mesh.colours.size()), "is not one for each position");
  triangles_key(keys, mesh);
}

void model_keys(Keys& keys, ModelFile& model) {
  keys.text({"file", "OBJ, glTF, PLY, ...; beside the scene file", true}, model.file);
  keys.flag({"own_materials", "those of the file, not the object's"}, model.own_materials);
  keys.flag({"unit_size", "moved and scaled into the unit sphere around the origin"}, model.unit_size);
}

void hole_keys(Keys& keys, std::vector<glm::dvec3>& corners) {
  vectors_key(keys, {"points", "its corners, in the polygon's plane", true}, corners);
  keys.require("points", corners.size() >= 3, "is of fewer than 3 corners");
}

void polygon_keys(Keys& keys, Polygon& polygon) {
  vectors_key(keys, {"outline", "its corners, in one plane, counter-clockwise from its front", true}, polygon.outline);
  keys.require("outline", polygon.outline.size() >= 3, "is of fewer than 3 corners");
  keys.list({"holes", "what is cut out of it"}, polygon.holes, hole_keys);
}

void polyhedron_keys(Keys& keys, Polyhedron& polyhedron) {
  vectors_key(keys, {"planes", "[nx, ny, nz, d] each: inside of all of them, n.p + d is 0 or less", true}, polyhedron.planes);
  const auto has_normal = [](const glm::dvec4& plane) { return glm::dvec3(plane) != glm::dvec3(0); };
  keys.require("planes", !polyhedron.planes.empty(), "is empty");
  keys.require("planes", std::all_of(polyhedron.planes.begin(), polyhedron.planes.end(), has_normal), "has a normal that is no direction");
}

void quadric_keys(Keys& keys, Quadric& quadric) {
  std::vector<glm::dvec4> rows;
  for (int i = 0; i < 4; ++i) rows.push_back(quadric.q[i]);
  vectors_key(keys, {"q", "4 rows, symmetric: the surface has (p, 1).q (p, 1) = 0, its inside less", true}, rows);
  keys.require("q", rows.size() == 4, "is not of 4 rows");
  for (int i = 0; i < 4 && static_cast<std::size_t>(i) < rows.size(); ++i) quadric.q[i] = rows[static_cast<std::size_t>(i)];
  keys.require("q", glm::transpose(quadric.q) == quadric.q, "is not symmetric");
  keys.vector({"lower", "corner of the box that the surface is cut to"}, quadric.lower);
  keys.vector({"upper", "the other corner"}, quadric.upper);
  keys.require("upper", glm::all(glm::lessThan(quadric.lower, quadric.upper)), "is not above lower");
}

template <class T>
void keys_where(Keys& keys, Shape& shape, std::size_t wanted, std::size_t index, void (*visit)(Keys&, T&)) {
  keys.where("type is " + std::string(kShapes[index]), wanted == index, [&] {
    if (!std::holds_alternative<T>(shape)) shape.emplace<T>();
    visit(keys, std::get<T>(shape));
  });
}

}  // namespace

void shape_keys(Keys& keys, Shape& shape) {
  std::size_t index = shape.index();
  keys.one_of({"type", "", true}, index, kShapes);
  keys_where(keys, shape, index, 0, plane_keys);
  keys_where(keys, shape, index, 1, cube_keys);
  keys_where(keys, shape, index, 2, sphere_keys);
  keys_where(keys, shape, index, 3, capped_keys<Cylinder>);
  keys_where(keys, shape, index, 4, capped_keys<Cone>);
  keys_where(keys, shape, index, 5, torus_keys);
  keys_where(keys, shape, index, 6, disc_keys);
  keys_where(keys, shape, index, 7, teapot_keys);
  keys_where(keys, shape, index, 8, bezier_keys);
  keys_where(keys, shape, index, 9, height_field_keys);
  keys_where(keys, shape, index, 10, mesh_keys);
  keys_where(keys, shape, index, 11, model_keys);
  // All of an infinite plane is said by its type, number 12.
  if (index == 12 && !std::holds_alternative<InfinitePlane>(shape)) shape = InfinitePlane{};
  keys_where(keys, shape, index, 13, polygon_keys);
  keys_where(keys, shape, index, 14, polyhedron_keys);
  keys_where(keys, shape, index, 15, quadric_keys);
}

}  // namespace tuberia::description
