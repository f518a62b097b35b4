// Refraction, Fresnel's and Beckmann's formulas, unit vectors and mirrors: cases 48, 49, 51 and 57, rules S1
// to S3, as functions of math/. The techniques that will draw with them have tests of their own.

#include "math/optics.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>

#include "math/transforms.hpp"
#include "tests/support/random.hpp"
#include "tests/support/render.hpp"

namespace tuberia {

namespace {

double radians_of(double degrees) { return degrees * std::numbers::pi / 180; }

/// Light that arrives from the left at this angle to the normal (0, 0, 1).
glm::dvec3 arriving_at(double degrees) { return {std::sin(radians_of(degrees)), 0, -std::cos(radians_of(degrees))}; }

double mean_reflectance(double degrees, double n_from, double n_into) { return fresnel(std::cos(radians_of(degrees)), n_from, n_into).mean(); }

}  // namespace

TEST_CASE("fresnel: the shares that air and glass reflect", "[extremes][S3][case-48]") {
  struct Known {
    double degrees, reflected;
  };
  for (const Known& k : {Known{0, .04}, {30, .04152262597582154}, {45, .05023991101223594}, {60, .08918671280221278}, {75, .2530605629903197},
                         {85, .6127996452648274}, {89, .9041849497801891}})
    CHECK(mean_reflectance(k.degrees, 1, 1.5) == Approx(k.reflected).epsilon(1e-12));
  for (const Known& k : {Known{20, .04172851819062224}, {40, .2452912042869103}, {41.8, .8907719214997444}, {41.82, 1}, {60, 1}, {90, 1}})
    CHECK(mean_reflectance(k.degrees, 1.5, 1) == Approx(k.reflected).epsilon(1e-10));
  CHECK(fresnel(std::cos(radians_of(56.309932474020213)), 1, 1.5).parallel < 1e-28);  // Brewster's angle
  CHECK(radians_of(41.810314895778598) == Approx(std::asin(1 / 1.5)).epsilon(1e-14));  // the critical one
  CHECK(mean_reflectance(41.810314895778598 - 1e-9, 1.5, 1) < 1);
  CHECK(mean_reflectance(41.810314895778598 + 1e-9, 1.5, 1) == 1);
}

TEST_CASE("fresnel: what is not reflected goes through, the same both ways", "[extremes][S3][case-48]") {
  // Seen from the other side, at the angle of refraction, a surface reflects as much.
  for (int i = 1; i < 90; ++i) {
    const glm::dvec3 in = arriving_at(i);
    const auto out = refracted(in, {0, 0, 1}, 1, 1.5);
    REQUIRE(out);
    const Reflectance there = fresnel(-in.z, 1, 1.5), back = fresnel(-out->z, 1.5, 1);
    CHECK(there.perpendicular == Approx(back.perpendicular).epsilon(1e-10));
    CHECK(there.parallel == Approx(back.parallel).margin(1e-14));
    // Reflected and transmitted are 1, the transmitted share by its own formula.
    const double a = 2 * -in.z / (-in.z + 1.5 * -out->z), b = 2 * -in.z / (1.5 * -in.z - out->z), wider = 1.5 * out->z / in.z;
    CHECK(there.perpendicular + wider * a * a == Approx(1).epsilon(1e-12));
    CHECK(there.parallel + wider * b * b == Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("refraction: Snell's law, up to the critical angle", "[extremes][S3][case-48]") {
  const auto out = refracted(arriving_at(45), {0, 0, 1}, 1, 1.5);
  REQUIRE(out);
  CHECK(std::atan2(out->x, -out->z) == Approx(radians_of(28.12550570205571)).epsilon(1e-13));
  CHECK(glm::length(*out) == Approx(1).epsilon(1e-15));
  CHECK(refracted(arriving_at(41.8), {0, 0, 1}, 1.5, 1).has_value());
  CHECK_FALSE(refracted(arriving_at(41.82), {0, 0, 1}, 1.5, 1).has_value());
  CHECK(refracted(arriving_at(0), {0, 0, 1}, 1, 2.42) == glm::dvec3(0, 0, -1));
}

TEST_CASE("beckmann: known densities, and none at the horizon or below", "[extremes][S2][case-49]") {
  struct Known {
    double roughness, degrees, density;
  };
  for (const Known& k : {Known{.1, 0, 31.830988618379067}, {.5, 30, .59666186689415067}, {1, 60, .25356345704959}, {.001, 0, 318309.88618}, {.001, .1, 15132.5961326}})
    CHECK(beckmann(std::cos(radians_of(k.degrees)), k.roughness) == Approx(k.density).epsilon(1e-9));
  for (const double roughness : {.001, .1, 1.0, 10.0}) {
    CHECK(beckmann(0, roughness) == 0);
    CHECK(beckmann(-0.5, roughness) == 0);
    for (const double grazing : {1e-300, 1e-150, 1e-80, 1e-4}) CHECK((beckmann(grazing, roughness) >= 0 && std::isfinite(beckmann(grazing, roughness))));
    CHECK(beckmann(1e-80, roughness) == 0);
  }
}

TEST_CASE("beckmann: the facets' shadows cover the surface once", "[extremes][S2][case-49]") {
  // 2 pi times the integral of D cos sin, over c = cos^2, by the midpoint rule: fine where D is steep.
  for (const double roughness : {0.05, 0.2, 0.5, 1.0, 2.0}) {
    constexpr int kSteps = 200000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) sum += beckmann(std::sqrt((i + 0.5) / kSteps), roughness);
    CHECK(std::numbers::pi * sum / kSteps == Approx(1).epsilon(1e-4));
  }
}

TEST_CASE("unit vectors: any finite vector but 0, the fallback for the others", "[extremes][S1][case-51]") {
  const glm::dvec3 fallback{0, 0, 1};
  for (const glm::dvec3& v : {glm::dvec3(1e-25, 0, 0), {1e25, 1e25, 0}, {1e-40, 0, 0}, {1e-310, -1e-310, 0}, {1e308, 1e308, -1e308}, {5e-324, 0, 0}}) {
    const glm::dvec3 unit = normalized_or(v, fallback);
    CHECK(glm::length(unit) == Approx(1).epsilon(4 * std::numeric_limits<double>::epsilon()));
    for (int axis = 0; axis < 3; ++axis) CHECK((unit[axis] > 0) == (v[axis] > 0));
  }
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& none : {glm::dvec3(0), glm::dvec3(-0.0), {nan, 1, 0}, {0, inf, 0}}) CHECK(normalized_or(none, fallback) == fallback);
}

TEST_CASE("mirrors: a direction bounces off a normal of any length", "[extremes][S1][case-53]") {
  CHECK(reflected({1, -1, 0}, {0, 1, 0}) == glm::dvec3(1, 1, 0));
  CHECK(reflected({1, -1, 0}, {0, -4, 0}) == glm::dvec3(1, 1, 0));
  CHECK(reflected({1, -1, 0}, {0, 0, 0}) == glm::dvec3(1, -1, 0));
}

TEST_CASE("mirrors: a point and its image, and back again", "[extremes][case-57]") {
  const glm::mat4 m = mirror({1, 2, 2}, 9);  // n = (1, 2, 2) / 3, d = 3
  const glm::vec4 image = m * glm::vec4(4, 5, 6, 1);
  CHECK(image.x == Approx(2.0 / 9).margin(2e-6));
  CHECK(image.y == Approx(-23.0 / 9).epsilon(1e-6));
  CHECK(image.z == Approx(-14.0 / 9).epsilon(1e-6));
  const glm::mat4 twice = compose(m, m);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) CHECK(twice[column][row] == Approx(column == row ? 1 : 0).margin(2e-6));
  CHECK(glm::determinant(glm::dmat4(m)) == Approx(-1).epsilon(1e-6));
  CHECK(mirror({0, 0, 0}, 5) == glm::mat4(1.0f));
  CHECK(mirror({0, 0, 1}, 0) == scaling({1, 1, -1}));
}

TEST_CASE("mirrors: what faced the eye is turned away", "[extremes][case-57]") {
  test::Mesh mesh;
  mesh.positions = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.1f, 0.5f, 0}};
  PipelineState state;
  state.culling.cull = CullFace::back;
  CHECK(test::pixels_drawn(test::render(mesh, flat(), state).colour) > 0);
  const std::int64_t pixels = test::pixels_drawn(test::render(mesh, flat(), state).colour);
  state.transform.world_from_object = mirror({1, 0, 0}, 0);
  CHECK(test::pixels_drawn(test::render(mesh, flat(), state).colour) == 0);
  state.culling.front_face = Winding::clockwise;
  CHECK(test::pixels_drawn(test::render(mesh, flat(), state).colour) == pixels);
}

TEST_CASE("mirrors: a picture drawn through a mirror and its mirror image is the picture", "[extremes][R6][case-57]") {
  // The plane x = 0 as a mirror: exact in floats, so that mirrored twice every bit is the same.
  test::Random random(57);
  test::Mesh mesh;
  for (int i = 0; i < 90; ++i) {
    mesh.positions.push_back({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
    mesh.colours.push_back({random.between(0, 1), random.between(0, 1), random.between(0, 1), 1});
  }
  PipelineState state;
  const auto digest = [&] {
    test::Studio studio({.colour = ColourFormat::rgba32f});
    studio.draw(mesh.view(), gouraud(), state);
    return studio.digest();
  };
  const std::string once = digest();
  state.transform.world_from_object = mirror({1, 0, 0}, 0);
  CHECK(digest() != once);
  state.transform.clip_from_world = mirror({1, 0, 0}, 0);
  CHECK(digest() == once);
}

}  // namespace tuberia
