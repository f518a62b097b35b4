// Texture coordinates by a function of position or normal.

#include "scene/sphere_mapping.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "scene/shapes/shapes.hpp"
#include "scene/vertex_normals.hpp"

namespace tuberia {

TEST_CASE("sphere mapping: the notes' numbers", "[B33]") {
  const auto check = [](const glm::dvec3& normal, const glm::dvec2& expected) {
    const glm::dvec2 actual = sphere_coordinates(normal);
    CAPTURE(normal.x, normal.y, normal.z);
    CHECK(actual.x == Approx(expected.x).margin(1e-12));
    CHECK(actual.y == Approx(expected.y).margin(1e-12));
  };
  check({1, 0, 0}, {0, 0.5});
  check({0, 0, -1}, {0.25, 0.5});
  check({-1, 0, 0}, {0.5, 0.5});
  check({0, 0, 1}, {0.75, 0.5});
  check({0, 1, 0}, {0, 1});
  check({0, -1, 0}, {0, 0});
  const glm::dvec2 diagonal = sphere_coordinates(glm::dvec3(1) / std::sqrt(3.0));
  CHECK(diagonal.x == Approx(0.875).margin(1e-12));
  CHECK(diagonal.y == Approx(0.69591).margin(1e-5));
}

TEST_CASE("sphere mapping: it is the inverse of longitude and latitude, on any axes", "[B33]") {
  const SphereAxes axes{.pole = glm::normalize(glm::dvec3(1, 2, 2)), .equator = glm::normalize(glm::dvec3(2, -2, 1))};
  const glm::dvec3 across = glm::cross(axes.pole, axes.equator);
  for (int i = 0; i < 24; ++i)
    for (int j = 1; j < 12; ++j) {
      const double longitude = 2 * std::numbers::pi * (i + 0.5) / 24, polar = std::numbers::pi * j / 12;  // from the south
      const glm::dvec3 normal = -std::cos(polar) * axes.pole + std::sin(polar) * (std::cos(longitude) * axes.equator + std::sin(longitude) * across);
      const glm::dvec2 uv = sphere_coordinates(normal, axes);
      CHECK(uv.x == Approx((i + 0.5) / 24));
      CHECK(uv.y == Approx(j / 12.0));
    }
}

TEST_CASE("sphere mapping: any mapping fills a mesh", "[B32]") {
  const TextureMapping plan{.coordinates = [](const glm::dvec3& position, const glm::dvec3&) { return glm::dvec2(position.x, position.z); }};
  const Mesh mesh = *with_texture_mapping(*box_mesh(), plan);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) CHECK(mesh.texcoords[i] == glm::vec2(mesh.positions[i].x, 1 - mesh.positions[i].z));
  CHECK(mesh.tangents.empty());

  const TextureMapping lost{.coordinates = [](const glm::dvec3& position, const glm::dvec3&) { return glm::dvec2(1 / (position.x - 1), 0); }};
  CHECK(with_texture_mapping(*box_mesh(), lost).error().message == "texture mapping: the coordinates of vertex 0 are not finite");
  Mesh nameless;
  nameless.name = "x";
  CHECK(with_texture_mapping(nameless, plan).error().message == "mesh 'x' has no normals to map a texture by");
}

TEST_CASE("sphere mapping: a sphere gets its own parameters back, seam and poles included", "[B32][B33]") {
  // Without its own coordinates, vertices of one position are one again; the mapping must split them anew.
  const Mesh own = *sphere_mesh({.slices = 12, .stacks = 6});
  const Mesh mapped = *with_texture_mapping(own, *sphere_mapping());
  REQUIRE(mapped.indices.size() == own.indices.size());
  for (std::size_t i = 0; i < own.indices.size(); ++i) {
    const glm::vec2 a = own.texcoords[own.indices[i]], b = mapped.texcoords[mapped.indices[i]];
    CHECK(std::abs(a.y - b.y) < 1e-6f);
    CHECK(std::abs(std::remainder(a.x - b.x, 1.0f)) < 1e-6f);
  }
  const auto spread = [&](std::size_t triangle) {
    const auto u = [&](std::size_t k) { return mapped.texcoords[mapped.indices[3 * triangle + k]].x; };
    return std::max({u(0), u(1), u(2)}) - std::min({u(0), u(1), u(2)});
  };
  for (std::size_t triangle = 0; triangle < mapped.indices.size() / 3; ++triangle) CHECK(spread(triangle) < 1.01f / 12);
  const Mesh with = *with_tangents(mapped);
  CHECK(with.tangents.size() == with.positions.size());
}

TEST_CASE("sphere mapping: axes that are none are refused, others made clean", "[B33]") {
  CHECK(sphere_mapping({.pole = {0, 0, 0}}).error().message == "sphere mapping: the axis to the pole has no direction");
  CHECK(sphere_mapping({.equator = {std::numeric_limits<double>::quiet_NaN(), 0, 0}}).error().message ==
        "sphere mapping: the axis to the equator has no direction");
  CHECK(sphere_mapping({.pole = {0, 2, 0}, .equator = {0, -3, 0}}).error().message ==
        "sphere mapping: the axes to the pole and to the equator are parallel");
  const TextureMapping skewed = *sphere_mapping({.pole = {0, 5, 0}, .equator = {3, 4, 0}}, true);
  CHECK(glm::distance(skewed.coordinates({0, 0, -7}, {1, 0, 0}), glm::dvec2(0.25, 0.5)) < 1e-12);  // of the position
  CHECK(std::isfinite(skewed.coordinates({0, 0, 0}, {1, 0, 0}).x));                                // the middle has no direction
}

}  // namespace tuberia
