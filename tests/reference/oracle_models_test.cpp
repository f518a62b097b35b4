// The oracle's lighting, matrices, maps and footprints against closed forms.

#include <catch2/catch.hpp>
#include <cmath>

#include "reference/oracle/footprint.hpp"
#include "reference/oracle/lighting.hpp"
#include "reference/oracle/matrices.hpp"
#include "reference/oracle/texture_coordinates.hpp"

namespace tuberia::oracle {
namespace {

bool holds_closely(Interval bounds, double value) {
  return bounds.low <= value && value <= bounds.high && bounds.high - bounds.low < 1e-4 * (1 + std::abs(value));
}

TEST_CASE("oracle: a light at 60 degrees, its mirror image in the eye", "[reference]") {
  Lighting lighting;
  lighting.ambient = glm::vec3(0.0625f);
  lighting.diffuse = glm::vec3(0.5f);
  lighting.specular = glm::vec3(0.25f);
  lighting.shininess = 8;
  lighting.alpha = 0.75f;
  const float sine = std::sqrt(3.0f) / 2;
  lighting.lights = {{.is_point = false, .towards = {sine, 0, 0.5f}, .intensity = glm::vec3(1)}};
  lighting.eye = {-2 * sine, 0, 1};
  for (const bool halfway : {false, true}) {
    lighting.halfway = halfway;
    CHECK(holds_closely(lit(lighting, {0, 0, 0}, {0, 0, 1})[0], 0.0625 + 0.25 + 0.25));
    CHECK(lit(lighting, {0, 0, 0}, {0, 0, -1})[0] == Interval(0.0625));
  }
  CHECK(lit(lighting, {0, 0, 0}, {0, 0, 1})[3] == Interval(0.75));
  lighting.two_sided = true;
  CHECK(holds_closely(lit(lighting, {0, 0, 0}, {0, 0, -1})[0], 0.5625));
}

TEST_CASE("oracle: highlights off the mirror direction, by half the angle or the whole", "[reference]") {
  Lighting lighting;
  lighting.diffuse = glm::vec3(0);
  lighting.specular = glm::vec3(1);
  lighting.shininess = 2;
  lighting.lights = {{.is_point = true, .towards = {0, 0, 5}, .intensity = glm::vec3(1)}};
  lighting.eye = {std::sqrt(3.0f), 0, 1};  // 60 degrees from the normal and the light
  lighting.halfway = false;
  CHECK(holds_closely(lit(lighting, {0, 0, 0}, {0, 0, 1})[1], 0.25));
  lighting.halfway = true;
  CHECK(holds_closely(lit(lighting, {0, 0, 0}, {0, 0, 1})[1], 0.75));
}

TEST_CASE("oracle: normals stay upright where space is stretched, and turn with mirrors", "[reference]") {
  glm::mat4 stretched(1);
  stretched[0][0] = 2;
  const glm::vec3 slanted = transformed_normal(normal_matrix(stretched), {1, 0, 1});
  CHECK(std::abs(slanted.z / slanted.x - 2) < 1e-6f);
  glm::mat4 mirror(1);
  mirror[2][2] = -1;
  CHECK(transformed_normal(normal_matrix(mirror), {0, 0, 1}) == glm::vec3(0, 0, -1));
  CHECK(transformed_normal(glm::mat3(1), {0, 3e-30f, 0}) == glm::vec3(0, 1, 0));
  CHECK(transformed_normal(glm::mat3(1), {0, 0, 0}) == glm::vec3(0));
}

TEST_CASE("oracle: what mirrors and spheres reflect", "[reference]") {
  Draw draw;
  draw.has_normals = true;
  TexCoordUnit& unit = draw.texcoord_units[0];
  InputVertex vertex;
  vertex.position = {0, 0, -4, 1};
  const auto made = [&](TexCoordSource s, TexCoordSource r) {
    unit.source = {s, s, r, TexCoordSource::vertex};
    return UnitCoordinates(draw, 0)(vertex);
  };
  vertex.normal = {0, 0, 2};
  CHECK(made(TexCoordSource::reflection_map, TexCoordSource::reflection_map) == glm::vec4(0, 0, 1, 1));
  CHECK(made(TexCoordSource::sphere_map, TexCoordSource::normal_map) == glm::vec4(0.5f, 0.5f, 1, 1));
  vertex.normal = {1, 0, 0};  // seen along its edge: straight on, where a sphere map has no direction
  CHECK(made(TexCoordSource::reflection_map, TexCoordSource::reflection_map) == glm::vec4(0, 0, -1, 1));
  CHECK(made(TexCoordSource::sphere_map, TexCoordSource::vertex) == glm::vec4(0.5f, 0.5f, 0, 1));
}

TEST_CASE("oracle: a footprint of four by one texels takes four samples of the finest level", "[reference]") {
  const Steps upright{{1.0, 0.0, 0.0}, {0.0, 4.0, 0.0}};
  const Footprint footprint = elliptic_footprint(upright, 16);
  CHECK(holds_closely(footprint.taps, 4));
  CHECK(holds_closely(footprint.level_of_detail, 0));
  CHECK(holds_closely(footprint.along_x, 0));
  CHECK(holds_closely(absolute(footprint.along_y), 1));
  CHECK(holds_closely(elliptic_footprint(upright, 2).level_of_detail, 1));
  CHECK(holds_closely(round_footprint(upright).level_of_detail, 2));
}

}  // namespace
}  // namespace tuberia::oracle
