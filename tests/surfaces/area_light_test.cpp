#include "scene/area_light.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "pipeline/programs/surface.hpp"
#include "tests/support/lit_triangle.hpp"

namespace tuberia {

TEST_CASE("area light: it is as many points", "[surfaces][B02]") {
  const AreaLight area{.corner = {-0.5f, -0.5f, 1}, .edge_u = {1, 0, 0}, .edge_v = {0, 1, 0}, .intensity = glm::vec3(2), .falloff = Falloff::inverse_square};
  const test::LitTriangle flat{.size = 8};
  const auto picture = [&](int each_way) {
    SurfaceUniforms uniforms{.reflection = {.model = Reflection::lambert, .diffuse = glm::vec3(1)}, .ambient_light = glm::vec3(0)};
    const auto lights = point_lights_of(area, each_way);
    for (const Light& light : *lights) uniforms.lights.push_back({.light = light});
    return flat.picture(surface(uniforms), InstructionSet::baseline, Precision::exact);
  };
  // Against the integral over the rectangle, by many more points in double.
  const glm::dvec3 at = flat.position(5, 2);
  double right = 0;
  for (int j = 0; j < 200; ++j)
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 way = glm::dvec3((i + 0.5) / 200 - 0.5, (j + 0.5) / 200 - 0.5, 1) - at;
      right += 2.0 / 40000 * inverse_square_falloff(glm::length(way)) * way.z / glm::length(way);
    }
  const double four = std::abs(static_cast<double>(picture(2).at(5, 2).r) - right), many = std::abs(static_cast<double>(picture(8).at(5, 2).r) - right);
  CHECK(four < 0.05 * right);
  CHECK(many < four / 8);
  CHECK(point_lights_of(area, 0).error().message == "an area light of 0 points each way; it can be 1 to 64");
}

}  // namespace tuberia
