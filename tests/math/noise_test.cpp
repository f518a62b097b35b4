#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "math/bump.hpp"
#include "math/lattice_noise.hpp"
#include "tests/support/random.hpp"

namespace tuberia {
namespace {

glm::dvec3 somewhere(test::Random& random, float reach) {
  return {static_cast<double>(random.between(-reach, reach)), static_cast<double>(random.between(-reach, reach)), static_cast<double>(random.between(-reach, reach))};
}

}  // namespace

TEST_CASE("noise: within -1 and 1, 0 at the lattice, without jumps", "[math][noise]") {
  test::Random random(401);
  double least = 0, most = 0, sum_of_squares = 0;
  constexpr int kPoints = 20000;
  for (int i = 0; i < kPoints; ++i) {
    const glm::dvec3 p = somewhere(random, 100);
    const double value = gradient_noise(p, 7);
    least = std::min(least, value), most = std::max(most, value), sum_of_squares += value * value;
    // The steepest that noise can be, for each axis: the gradient's own 2/3 and what the weights add.
    CHECK(std::abs(gradient_noise(p + glm::dvec3(1e-6), 7) - value) < 1e-6 * 3 * 4);
    CHECK(gradient_noise(glm::dvec3(std::floor(p.x), std::floor(p.y), std::floor(p.z)), 7) == 0);
  }
  CHECK((least >= -1 && most <= 1));
  CHECK((least < -0.6 && most > 0.6));                       // it uses its range
  CHECK(std::sqrt(sum_of_squares / kPoints) > 0.15);
  CHECK(gradient_noise(glm::dvec3(0.5, 0.25, 0.75), 1) != gradient_noise(glm::dvec3(0.5, 0.25, 0.75), 2));
}

TEST_CASE("noise: coordinates that are no numbers or too large count as 0", "[math][noise]") {
  for (const double odd : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), std::nan(""), 1e30, 4194304.0}) {
    CHECK(gradient_noise(glm::dvec3(odd, 0.25, 0.75), 3) == gradient_noise(glm::dvec3(0, 0.25, 0.75), 3));
    CHECK(gradient_noise(glm::dvec2(0.25, odd), 8, 3).height == gradient_noise(glm::dvec2(0.25, 0), 8, 3).height);
    CHECK(std::isfinite(waves({odd, 0.1}, 4).height));
    CHECK(std::isfinite(orange({0.1, odd}, 4, 1).slope.x));
  }
}

TEST_CASE("relief: the analytic derivatives are those of the heights", "[math][bump][A08]") {
  test::Random random(402);
  using Relief = HeightAndSlope (*)(const glm::dvec2&);
  const std::pair<const char*, Relief> reliefs[] = {
      {"waves", [](const glm::dvec2& uv) { return waves(uv, 5); }}, {"orange", [](const glm::dvec2& uv) { return orange(uv, 6, 11); }},
      {"rough", [](const glm::dvec2& uv) { return rough(uv, 7, 12); }}, {"rough, no whole number", [](const glm::dvec2& uv) { return rough(uv, 3.5, 13); }}};
  for (const auto& named : reliefs)
    for (int i = 0; i < 2000; ++i) {
      const Relief relief = named.second;
      const glm::dvec3 p = somewhere(random, 2);
      const glm::dvec2 uv(p.x, p.y), step(1e-5);
      INFO(named.first << " at " << uv.x << ", " << uv.y << ", seed 402");
      const glm::dvec2 differences = central_differences([&](double u, double v) { return relief({u, v}).height; }, uv, step, 1);
      const glm::dvec2 slope = relief(uv).slope;
      // An orange's slope has corners (at the dimples' rims), which differences round off by step * curvature.
      CHECK(slope.x == Approx(differences.x).margin(2e-2));
      CHECK(slope.y == Approx(differences.y).margin(2e-2));
    }
}

TEST_CASE("relief: heights stay in their range, and whole scales close without a seam", "[math][bump]") {
  test::Random random(403);
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 p = somewhere(random, 1);
    const glm::dvec2 uv(p.x, p.y), next = uv + glm::dvec2(1, -2);
    CHECK(std::abs(waves(uv, 6).height) <= 1);
    CHECK(std::abs(rough(uv, 6, 1).height) <= 1);
    CHECK((orange(uv, 6, 1).height <= 0 && orange(uv, 6, 1).height >= -9));
    CHECK(waves(uv, 6).slope.x == Approx(waves(next, 6).slope.x).margin(1e-9));
    CHECK(rough(uv, 6, 1).slope.y == Approx(rough(next, 6, 1).slope.y).margin(1e-9));
    CHECK(orange(uv, 6, 1).height == Approx(orange(next, 6, 1).height).margin(1e-9));
  }
}

TEST_CASE("relief: central differences of a sine are right to the notes' 0.02 %", "[math][bump][A09]") {
  const double two_pi = 6.283185307179586, height = 0.3;
  const auto sine = [&](double u, double) { return height * std::sin(two_pi * u); };
  for (const double u : {0.0, 0.1, 0.4, 0.77}) {
    const glm::dvec2 slope = central_differences(sine, {u, 0.5}, glm::dvec2(1.0 / 256), 1);
    CHECK(slope.x == Approx(height * two_pi * std::cos(two_pi * u)).epsilon(2e-4));
    CHECK(slope.y == 0);
    CHECK(central_differences(sine, {u, 0.5}, glm::dvec2(1.0 / 256), -2).x == Approx(-2 * slope.x));
  }
}

TEST_CASE("relief: the notes' perturbed normals, mirrored coordinates included", "[math][bump][A09][A11]") {
  const SurfaceFrame frame;
  const auto is = [](const glm::dvec3& n, double x, double y, double z) {
    CHECK(n.x == Approx(x).margin(1e-4));
    CHECK(n.y == Approx(y).margin(1e-4));
    CHECK(n.z == Approx(z).margin(1e-4));
  };
  is(perturbed_normal(frame, {0.5, 0}), -0.44721, 0, 0.89443);
  is(perturbed_normal(frame, {0, 0.5}), 0, -0.44721, 0.89443);
  is(perturbed_normal(frame, {0, 0}), 0, 0, 1);
  const SurfaceFrame mirrored{.tangent = {-1, 0, 0}};
  is(perturbed_normal(mirrored, {0, 0}), 0, 0, 1);
  is(perturbed_normal(mirrored, {0.5, 0}), 0.44721, 0, 0.89443);  // the height grows towards -x
  is(perturbed_normal(mirrored, {0, 0.5}), 0, -0.44721, 0.89443);
  // Tangents keep their lengths: on a surface twice as long the same height is half as steep.
  is(perturbed_normal({.tangent = {2, 0, 0}}, {1, 0}), -0.44721, 0, 0.89443);
  is(mapped_normal(frame, {-0.44721, 0, 0.89443}, 1), -0.44721, 0, 0.89443);
  is(mapped_normal(frame, {0, 0.44721, 0.89443}, 1), 0, -0.44721, 0.89443);  // green is up, where v is less
}

TEST_CASE("relief: any frame and slope that make no sense leave the normal as it is", "[math][bump]") {
  const double endless = std::numeric_limits<double>::infinity();
  const glm::dvec3 n = glm::dvec3(0.6, 0, 0.8);
  for (const SurfaceFrame& frame : {SurfaceFrame{{0, 0, 0}, {0, 1, 0}, n}, SurfaceFrame{{0, 1, 0}, {0, 2, 0}, n}, SurfaceFrame{n, {0, 1, 0}, n},
                                    SurfaceFrame{{endless, 0, 0}, {0, 1, 0}, n}, SurfaceFrame{{std::nan(""), 0, 0}, {0, 1, 0}, n}})
    CHECK(perturbed_normal(frame, {0.3, -0.2}) == n);
  for (const glm::dvec2 slope : {glm::dvec2(endless, 0), glm::dvec2(0, std::nan("")), glm::dvec2(0, 0)})
    CHECK(perturbed_normal({{1, 0, 0}, {0, 1, 0}, n}, slope) == n);
}

}  // namespace tuberia
