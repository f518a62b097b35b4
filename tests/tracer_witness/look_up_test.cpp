// The surroundings' picture made once more.

#include <catch2/catch.hpp>

#include <cmath>
#include <glm/geometric.hpp>

#include "examples/tuberia/witness/environment_look_up.hpp"
#include "scene/environment/sky.hpp"

namespace tuberia::witness {
namespace {

using LookUp = description::Environment::LookUp;

EnvironmentLookUp look_up_of(LookUp kind, int resolution) {
  SceneDescription scene;
  scene.environment.emplace();
  scene.environment->look_up = kind;
  scene.environment->resolution = resolution;
  scene.environment->sky = {.sun = {0, 0, 0}, .cloudiness = 0};
  auto made = EnvironmentLookUp::create(scene, *scene.environment, Camera{});
  REQUIRE(made);
  return *made;
}

glm::dvec3 direction_number(int i) { return glm::normalize(glm::dvec3(std::sin(1.7 * i), std::cos(2.3 * i) * 0.9 + 0.2, std::sin(0.9 * i + 1))); }

}  // namespace

TEST_CASE("tracer witness: all maps show one sky where it changes slowly", "[Y5][tracer_witness]") {
  const EnvironmentLookUp cube = look_up_of(LookUp::cube, 64), panorama = look_up_of(LookUp::panorama, 64), ball = look_up_of(LookUp::sphere, 128);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 d = direction_number(i);
    const double to_sun = glm::dot(d, glm::normalize(glm::dvec3(0.3, 0.5, -0.8)));
    if (std::abs(d.y) < 0.1 || d.z < -0.9 || to_sun > 0.9) continue;  // the horizon and the sun are sharp, and a ball's rim coarse
    CAPTURE(d.x, d.y, d.z);
    for (const EnvironmentLookUp* other : {&panorama, &ball}) CHECK(glm::length(other->radiance(d, {d, d, d}) - cube.radiance(d, {d, d, d})) < 0.02);
  }
}

TEST_CASE("tracer witness: wide steps read the mean of everything", "[Y5][tracer_witness]") {
  const EnvironmentLookUp cube = look_up_of(LookUp::cube, 32);
  // A step as long as a face is wide asks for its last level: one texel each.
  const glm::dvec3 up(0, 1, 0), step(2, 0, 0);
  const glm::dvec3 coarse = cube.radiance(up, {up, up + step, up});
  glm::dvec3 mean(0);
  for (int j = 0; j < 32; ++j)
    for (int i = 0; i < 32; ++i) {
      const glm::dvec3 d = glm::normalize(glm::dvec3((i + 0.5) / 16 - 1, 1, (j + 0.5) / 16 - 1));
      mean += cube.radiance(d, {d, d, d}) / 1024.0;
    }
  CHECK(glm::length(coarse - mean) < 1e-4);
  // Half as wide: a level below, which in the middle of the face is the mean of the same.
  CHECK(glm::length(cube.radiance(up, {up, up + 0.5 * step, up}) - mean) < 1e-4);
}

}  // namespace tuberia::witness
