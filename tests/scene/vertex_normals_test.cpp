// Normals and tangents made from a net of triangles.

#include "scene/vertex_normals.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "math/transforms.hpp"
#include "scene/mesh_editing.hpp"
#include "scene/mesh_repair.hpp"
#include "scene/shapes/shapes.hpp"
#include "tests/scene/mesh_measures.hpp"

namespace tuberia {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Mesh bare(Mesh mesh) {
  mesh.normals.clear();
  mesh.tangents.clear();
  mesh.bitangents.clear();
  return mesh;
}

/// Two rectangles that meet at the z axis, each `slope_degrees` steep: a roof, its ridge up.
Mesh roof(double slope_degrees) {
  const auto run = static_cast<float>(std::cos(slope_degrees * kDegree)), rise = static_cast<float>(std::sin(slope_degrees * kDegree));
  Mesh mesh;
  mesh.positions = {{-run, -rise, 1}, {0, 0, 1}, {run, -rise, 1}, {-run, -rise, -1}, {0, 0, -1}, {run, -rise, -1}};
  mesh.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  return mesh;
}

double worst_angle_degrees(const std::vector<glm::vec3>& normals, const std::vector<glm::vec3>& expected) {
  double worst = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const glm::dvec3 a(normals[i]), b(expected[i]);
    worst = std::max(worst, std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) / kDegree);
  }
  return worst;
}

/// A triangle with given texture coordinates at p = (0, 0, 0), (2, 0, 0), (0, 3, 0), normal +z.
Mesh one_triangle(std::vector<glm::vec2> texcoords) {
  Mesh mesh;
  mesh.name = "one";
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.texcoords = std::move(texcoords);
  mesh.indices = {0, 1, 2};
  return mesh;
}

}  // namespace

TEST_CASE("vertex normals: a cube's corners lean to all three sides alike, however its faces are cut", "[B23]") {
  for (const NormalWeight weight : {NormalWeight::equal, NormalWeight::by_angle})
    for (const int segments : {1, 4}) {
      const Mesh cube = *with_vertex_normals(bare(*box_mesh({.segments = segments})), {.weight = weight});
      int corners = 0;
      for (std::size_t i = 0; i < cube.positions.size(); ++i) {
        if (glm::length(cube.positions[i]) < 1.7f) continue;
        CHECK(glm::distance(cube.normals[i], cube.positions[i] / std::sqrt(3.0f)) < 1e-6f);
        ++corners;
      }
      CHECK(corners == 24);  // three vertices at each, since the texture coordinates differ
    }
}

TEST_CASE("vertex normals: the mean of the adjacent polygons", "[B23]") {
  // A pyramid of unequal faces over a triangle: unit normals added, whatever the areas.
  Mesh mesh;
  mesh.positions = {{0, 1, 0}, {5, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 0, 2}};
  mesh.indices = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [a, b, c] = test::corners_of(mesh, i);
    sum += glm::normalize(glm::cross(b - a, c - a));
  }
  const Mesh smooth = *with_vertex_normals(mesh);
  CHECK(smooth.positions.size() == 5);
  CHECK(glm::distance(glm::dvec3(smooth.normals[0]), glm::normalize(sum)) < 1e-7);
}

TEST_CASE("vertex normals: edges sharper than the crease angle keep two normals", "[B26]") {
  const Mesh smooth = *with_vertex_normals(roof(20), {.crease_angle_radians = 41 * kDegree});
  CHECK(smooth.positions.size() == 6);
  CHECK(glm::distance(smooth.normals[smooth.indices[1]], glm::vec3(0, 1, 0)) < 1e-6f);  // on the ridge

  const Mesh sharp = *with_vertex_normals(roof(20), {.crease_angle_radians = 39 * kDegree});
  CHECK(sharp.positions.size() == 8);
  for (std::size_t corner = 0; corner < sharp.indices.size(); ++corner) {
    const double side = corner < 6 ? -1 : 1;
    const glm::dvec3 expected(side * std::sin(20 * kDegree), std::cos(20 * kDegree), 0);
    CHECK(glm::distance(glm::dvec3(sharp.normals[sharp.indices[corner]]), expected) < 1e-6);
  }
}

TEST_CASE("vertex normals: in one mesh a cube stays sharp and a sphere smooth", "[B26]") {
  const Mesh box = bare(*box_mesh({.width = 1, .height = 1, .depth = 1}));
  const Mesh sphere = *sphere_mesh({.radius = 0.6, .slices = 48, .stacks = 24});
  const Mesh both = *with_vertex_normals(joined(box, transformed(bare(sphere), translation({2, 0, 0}))), {.crease_angle_radians = 40 * kDegree});
  for (std::size_t i = 0; i < both.positions.size(); ++i) {
    const glm::vec3 p = both.positions[i], n = both.normals[i];
    if (p.x < 1) CHECK(glm::abs(n.x) + glm::abs(n.y) + glm::abs(n.z) == 1.0f);  // along an axis: its own face's
    else CHECK(glm::distance(n, (p - glm::vec3(2, 0, 0)) / 0.6f) < 0.01f);
  }
}

TEST_CASE("vertex normals: those of a fine net approach the ideal surface's, across the seam too", "[B23]") {
  for (const NormalWeight weight : {NormalWeight::equal, NormalWeight::by_angle}) {
    Mesh torus = *torus_mesh({.slices = 128, .stacks = 64});
    const Mesh made = *with_vertex_normals(bare(torus), {.weight = weight});
    CHECK(test::border_edges(made).empty());
    join_identical_vertices(torus);
    Mesh again = made;
    REQUIRE(again.positions == torus.positions);
    CHECK(worst_angle_degrees(again.normals, torus.normals) < (weight == NormalWeight::equal ? 3.0 : 0.3));
  }
}

TEST_CASE("vertex normals: facets keep the normal of their plane", "[B21]") {
  const Mesh facets = with_facet_normals(*sphere_mesh({.slices = 8, .stacks = 6}));
  for (std::size_t i = 0; i < facets.indices.size() / 3; ++i) {
    const auto [a, b, c] = test::corners_of(facets, i);
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    for (std::size_t k = 0; k < 3; ++k) CHECK(glm::distance(glm::dvec3(facets.normals[facets.indices[3 * i + k]]), normal) < 1e-6);
  }
  CHECK(with_facet_normals(bare(*box_mesh())).positions.size() == 24);  // halves of a face share their vertices
}

TEST_CASE("vertex normals: degenerate triangles and bad angles", "[B23]") {
  Mesh mesh = roof(20);
  for (const std::uint32_t index : {1u, 4u, 4u, 1u, 1u, 1u}) mesh.indices.push_back(index);
  mesh.positions.push_back({9, 9, 9});
  for (const std::uint32_t index : {6u, 6u, 6u}) mesh.indices.push_back(index);
  const Mesh sharp = *with_vertex_normals(mesh, {.crease_angle_radians = 0.1});
  CHECK(sharp.positions.size() == 9);  // flat triangles join no sides, and split nothing
  CHECK(sharp.normals[sharp.indices.back()] == glm::vec3(0, 0, 1));
  for (const double angle : {-0.1, 3.2, std::numeric_limits<double>::quiet_NaN()}) {
    const auto refused = with_vertex_normals(mesh, {.crease_angle_radians = angle});
    REQUIRE(!refused.ok());
    CHECK_THAT(refused.error().message, Catch::Contains("crease_angle_radians is ") && Catch::Contains("between 0 and pi"));
  }
  CHECK(with_vertex_normals(Mesh{})->normals.empty());
}

TEST_CASE("tangents: a triangle's from its texture coordinates", "[A10]") {
  for (const TangentKind kind : {TangentKind::by_polygon, TangentKind::by_vertex}) {
    const Mesh mesh = *with_tangents(one_triangle({{0, 0}, {1, 0}, {0, 1}}), kind);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(glm::distance(mesh.tangents[i], glm::vec3(2, 0, 0)) < 1e-6f);
      CHECK(glm::distance(mesh.bitangents[i], glm::vec3(0, 3, 0)) < 1e-6f);
    }
    // A general one: position is the linear function p = (2 u' + 1 v', 3 v') of rotated, scaled coordinates.
    const Mesh turned = *with_tangents(one_triangle({{0.1f, 0.2f}, {0.3f, 0.7f}, {-0.4f, 0.5f}}), kind);
    const glm::vec3 along_side = 0.2f * turned.tangents[0] + 0.5f * turned.bitangents[0];
    const glm::vec3 along_other = -0.5f * turned.tangents[0] + 0.3f * turned.bitangents[0];
    CHECK(glm::distance(along_side, glm::vec3(2, 0, 0)) < 1e-5f);
    CHECK(glm::distance(along_other, glm::vec3(0, 3, 0)) < 1e-5f);
  }
}

TEST_CASE("tangents: those of a fine net approach the analytic ones", "[A10]") {
  const Mesh sphere = *sphere_mesh({.slices = 128, .stacks = 64});
  Mesh made = sphere;
  made.tangents.clear();
  made.bitangents.clear();
  made = *with_tangents(made);
  std::map<std::pair<float, float>, std::size_t> by_texcoord;
  for (std::size_t i = 0; i < sphere.positions.size(); ++i) by_texcoord[{sphere.texcoords[i].x, sphere.texcoords[i].y}] = i;
  for (std::size_t i = 0; i < made.positions.size(); ++i) {
    const std::size_t ideal = by_texcoord.at({made.texcoords[i].x, made.texcoords[i].y});
    const float sine = glm::length(glm::vec2(made.positions[i].x, made.positions[i].z));
    if (sine < 0.2f) continue;  // near the poles the triangles say less
    CHECK(glm::distance(made.tangents[i], sphere.tangents[ideal]) < 0.01f * glm::length(sphere.tangents[ideal]) + 0.05f);
    CHECK(glm::distance(made.bitangents[i], sphere.bitangents[ideal]) < 0.04f * glm::length(sphere.bitangents[ideal]));
    CHECK(std::abs(glm::dot(made.tangents[i], made.normals[i])) < 1e-5f);
  }
}

TEST_CASE("tangents: mirrored halves of an image are not mixed", "[A10][A11]") {
  // Two squares beside each other; the image of the right one is the left one's mirrored. They share an edge.
  Mesh mesh;
  mesh.positions = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.normals.assign(6, {0, 0, 1});
  mesh.texcoords = {{0, 1}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {0, 0}};
  mesh.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  const Mesh made = *with_tangents(mesh);
  CHECK(made.positions.size() == 8);
  for (std::size_t corner = 0; corner < made.indices.size(); ++corner) {
    const std::uint32_t vertex = made.indices[corner];
    CHECK(made.tangents[vertex] == glm::vec3(corner < 6 ? 1 : -1, 0, 0));
    CHECK(made.bitangents[vertex] == glm::vec3(0, -1, 0));
  }
}

TEST_CASE("tangents: texture coordinates without area give some perpendicular pair", "[A10]") {
  const auto check_pair = [](const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const glm::vec3 u = mesh.tangents[i], v = mesh.bitangents[i];
      CHECK(glm::length(u) == Approx(1));
      CHECK(glm::length(v) == Approx(1));
      CHECK(glm::distance(glm::cross(v, u), mesh.normals[i]) < 1e-6f);
    }
  };
  for (const TangentKind kind : {TangentKind::by_polygon, TangentKind::by_vertex})
    for (const auto& texcoords : {std::vector<glm::vec2>{{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}}, {{0, 0}, {0.1f, 0.1f}, {0.3f, 0.3f}}}) {
      Mesh mesh = one_triangle(texcoords);
      check_pair(*with_tangents(mesh, kind));
      mesh.positions[2] = mesh.positions[1];  // no area, either
      mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}};
      check_pair(*with_tangents(mesh, kind));
    }
  Mesh without = one_triangle({});
  CHECK(with_tangents(without).error().message == "mesh 'one' has no texture coordinates, so it has no tangents");
  without = one_triangle({{0, 0}, {1, 0}, {0, 1}});
  without.normals.clear();
  CHECK(with_tangents(without).error().message == "mesh 'one' has no normals for tangents at its vertices");
}

TEST_CASE("mesh editing: moved meshes keep what their attributes mean", "[scene]") {
  const Mesh torus = *torus_mesh({.slices = 12, .stacks = 8});
  const glm::mat4 matrix = translation({1, 2, 3}) * scaling({-2, 1, 3}) * rotation({1, 1, 0}, 0.7);
  const Mesh moved = transformed(torus, matrix);
  CHECK(test::volume(moved) == Approx(6 * test::volume(torus)).epsilon(1e-4));  // positive: turned round with the mirror
  for (std::size_t i = 0; i < moved.positions.size(); ++i) {
    const glm::vec3 across = glm::normalize(glm::cross(moved.tangents[i], moved.bitangents[i]));  // mirrored now
    CHECK(glm::distance(across, moved.normals[i]) < 1e-4f);
  }
  const Mesh two = joined(torus, moved);
  CHECK(two.triangle_count() == 2 * torus.triangle_count());
  CHECK(test::volume(two) == Approx(7 * test::volume(torus)).epsilon(1e-4));
  CHECK(joined(torus, bare(moved)).normals.empty());
  CHECK(joined(Mesh{}, torus).positions == torus.positions);

  const Mesh tiled = *with_repeated_texture(torus, {4, 2});
  CHECK(tiled.texcoords.back() == glm::vec2(4, 2));
  CHECK(tiled.tangents[20] == torus.tangents[20] / 4.0f);
  CHECK(tiled.bitangents[20] == torus.bitangents[20] / 2.0f);
  CHECK(with_repeated_texture(torus, {0, 1}).error().message == "times.x is 0, but must be finite and not 0");
}

}  // namespace tuberia
