// Lights near, far and in cones: at fragments, at vertices and for interpolated cosines.

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/lit_triangle.hpp"

namespace tuberia {

namespace {

/// What of a light's intensity arrives, in double by the documents.
double arriving(const Light& light, const glm::dvec3& at) {
  const glm::dvec3 way = glm::dvec3(light.towards) - at;
  const double distance = glm::length(way);
  double share = 1;
  if (light.falloff == Falloff::linear) share = linear_falloff(distance, static_cast<double>(light.falloff_distance));
  if (light.falloff == Falloff::inverse_square) share = inverse_square_falloff(distance);
  if (light.kind != Light::Kind::spot) return share;
  const double cosine = -glm::dot(way / distance, glm::dvec3(light.axis)), outer = static_cast<double>(light.cos_outer), inner = static_cast<double>(light.cos_inner);
  const double t = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
  return share * t * t * (3 - 2 * t);
}

Lighting lit_by(const Light& light) {
  Lighting lighting{.ambient = glm::vec3(0), .diffuse = glm::vec3(0.5f), .specular = glm::vec3(0.25f), .shininess = 8, .halfway = false, .eye = {0.1f, 0.3f, 3}};
  lighting.lights[0] = light;
  return lighting;
}

constexpr Light kLamps[] = {
    {.kind = Light::Kind::point, .towards = {0.2f, -0.1f, 1.5f}, .falloff = Falloff::linear, .falloff_distance = 0.5f},
    {.kind = Light::Kind::point, .towards = {0.2f, -0.1f, 1.5f}, .intensity = glm::vec3(9), .falloff = Falloff::inverse_square},
    {.kind = Light::Kind::spot, .towards = {0.2f, -0.1f, 1.5f}, .axis = {0, 0, -1}, .cos_inner = 0.95f, .cos_outer = 0.8f},
    {.kind = Light::Kind::spot, .towards = {0.2f, -0.1f, 1.5f}, .intensity = glm::vec3(9), .falloff = Falloff::inverse_square, .axis = {0.6f, 0, -0.8f}, .cos_inner = 0.9f, .cos_outer = 0.7f}};

}  // namespace

TEST_CASE("lights: falloff and cone are as the documents say", "[pipeline][B02][B09][B10]") {
  const test::LitTriangle flat;
  for (const Light& lamp : kLamps) {
    const Lighting lighting = lit_by(lamp);
    test::for_every_machine([&](InstructionSet set, Precision precision) {
      const auto picture = flat.picture(phong(lighting), set, precision);
      for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
          const LitPoint at = flat.point(x, y, lamp, lighting.eye);
          const double share = 0.5 * diffuse_share(at) + 0.25 * phong_share(at, 8);
          const double right = static_cast<double>(lamp.intensity.r) * arriving(lamp, flat.position(x, y)) * share;
          CHECK(picture.at(x, y).r == Approx(right).epsilon(2e-5).margin(1e-6));
        }
    });
  }
}

TEST_CASE("lights: twice as far away a lamp gives a quarter of its light", "[pipeline][B09]") {
  const test::LitTriangle flat{.size = 4};
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const auto light_from = [&](float z) {
      Lighting lighting = lit_by({.kind = Light::Kind::point, .towards = {0, 0, z}, .intensity = glm::vec3(100), .falloff = Falloff::inverse_square});
      lighting.specular = glm::vec3(0);
      return flat.picture(phong(lighting), set, precision).at(2, 2).r;  // a quarter of a unit from the foot
    };
    CHECK(light_from(200) == Approx(light_from(100) / 4).epsilon(2e-5));
  });
}

// At the vertices: intensities for Gouraud shading, cosines for their interpolation; there both are exact.
TEST_CASE("lights: falloff and cone at vertices", "[pipeline][B09][B10][B30]") {
  // Where the corners lie, the picture of three small triangles would be; a triangle with one pixel is enough.
  test::LitTriangle flat{.size = 1};
  for (const Light& lamp : kLamps) {
    Lighting lighting = lit_by(lamp);
    PipelineState gouraud_state, cosine_state;
    gouraud_state.transform.vertex_lighting = lighting;
    cosine_state.transform.vertex_cosines = lighting;
    // All three vertices give what is at the first one: (-1, -1, 0).
    gouraud_state.rasterization.flat_shading = cosine_state.rasterization.flat_shading = true;
    const LitPoint at{{0, 0, 1}, normalized_or(glm::dvec3(lamp.towards) - glm::dvec3(-1, -1, 0), {}), normalized_or(glm::dvec3(lighting.eye) - glm::dvec3(-1, -1, 0), {})};
    const double right = static_cast<double>(lamp.intensity.r) * arriving(lamp, {-1, -1, 0}) * (0.5 * diffuse_share(at) + 0.25 * phong_share(at, 8));
    test::for_every_machine([&](InstructionSet set, Precision precision) {
      CHECK(flat.picture(gouraud(), set, precision, gouraud_state).at(0, 0).r == Approx(std::min(right, 1.0)).epsilon(2e-5).margin(1e-7));
      CHECK(flat.picture(dot_product(lighting), set, precision, cosine_state).at(0, 0).r == Approx(right).epsilon(5e-5).margin(1e-7));
    });
  }
}

TEST_CASE("lights: a light at the surface is a finite light", "[pipeline]") {
  // A pixel's centre is exactly at the light, its neighbours are next to it.
  const test::LitTriangle flat;
  for (const Falloff falloff : {Falloff::none, Falloff::linear, Falloff::inverse_square})
    for (const Light::Kind kind : {Light::Kind::point, Light::Kind::spot}) {
      const glm::dvec3 place = flat.position(5, 9);
      const Lighting lighting = lit_by({.kind = kind, .towards = place, .falloff = falloff, .falloff_distance = 0});
      test::for_every_machine([&](InstructionSet set, Precision precision) {
        const auto picture = flat.picture(phong(lighting), set, precision);
        for (const Rgba32F& pixel : picture.pixels()) CHECK((std::isfinite(pixel.r) && pixel.r >= 0));
        CHECK(picture.at(5, 9).r == 0);
      });
    }
}

TEST_CASE("lights: a spot with one angle has a sharp edge", "[pipeline][B02]") {
  const test::LitTriangle flat{.size = 64};
  Lighting lighting = lit_by({.kind = Light::Kind::spot, .towards = {0, 0, 1}, .axis = {0, 0, -1}, .cos_inner = 0.8f, .cos_outer = 0.8f});
  lighting.specular = glm::vec3(0);
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const auto picture = flat.picture(phong(lighting), set, precision);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const double radius = glm::length(flat.position(x, y));  // the cone's is 3/4 here
        const double cosine = 1 / std::sqrt(1 + radius * radius);
        CHECK(picture.at(x, y).r == Approx(radius < 0.75 ? 0.5 * cosine : 0).epsilon(1e-5));
      }
  });
}

// Rays of one light are parallel or not: the places where the light's direction is the normal's.
TEST_CASE("lights: directional light is parallel, a lamp's diverges", "[pipeline][B02]") {
  const test::LitTriangle flat{.size = 32};
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    Lighting far = lit_by({.towards = {0.6f, 0, 0.8f}}), near = lit_by({.kind = Light::Kind::point, .towards = {0.6f, 0, 0.8f}});
    far.specular = near.specular = glm::vec3(0);
    const auto parallel = flat.picture(phong(far), set, precision), diverging = flat.picture(phong(near), set, precision);
    for (const Rgba32F& pixel : parallel.pixels()) CHECK(pixel.r == Approx(0.4).epsilon(1e-6));
    CHECK(diverging.at(25, 16).r == Approx(0.5).epsilon(2e-3));  // under the lamp
    CHECK(diverging.at(0, 16).r < 0.25f);
  });
}

TEST_CASE("lights: what no light can be is refused", "[pipeline]") {
  const auto refusal = [](const Light& light, float shininess = 8) {
    Lighting lighting = lit_by(light);
    lighting.shininess = shininess;
    PipelineState state;
    state.transform.vertex_cosines = lighting;
    Pipeline pipeline({.threads = 1});
    RenderTarget target = *RenderTarget::create(8, 8);
    const test::Mesh mesh = test::LitTriangle{}.mesh();
    const auto drawn = pipeline.draw(target, {.mesh = mesh.view(), .program = dot_product(lighting), .state = state});
    return drawn ? "accepted" : drawn.error().message;
  };
  using Catch::Matchers::Contains;
  CHECK(refusal(kLamps[3]) == "accepted");
  CHECK_THAT(refusal({.kind = static_cast<Light::Kind>(3)}), Contains("lights[0].kind is 3; its enumeration ends with 2"));
  CHECK_THAT(refusal({.falloff = static_cast<Falloff>(9)}), Contains("lights[0].falloff is 9"));
  CHECK_THAT(refusal({.falloff_distance = -1}), Contains("lights[0].falloff_distance is -1; it must be finite and not negative"));
  CHECK_THAT(refusal({.kind = Light::Kind::spot, .axis = {0, NAN, 0}}), Contains("lights[0].axis.y is nan"));
  CHECK_THAT(refusal({.kind = Light::Kind::spot, .cos_inner = 0.2f, .cos_outer = 0.4f}), Contains("lights[0].cos_inner is 0.2, outside 0.4 to 1"));
  CHECK_THAT(refusal({.kind = Light::Kind::spot, .cos_outer = -2}), Contains("lights[0].cos_outer is -2"));
  // Interpolated cosines cannot carry a falloff where every power is 1.
  CHECK_THAT(refusal(kLamps[0], 0), Contains("shininess is 0") && Contains("lights[0]"));
}

}  // namespace tuberia
