#include "math/reflection.hpp"

#include <catch2/catch.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "math/optics.hpp"

namespace tuberia {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr glm::dvec3 kUp{0, 0, 1};

/// In the plane y = 0, so many degrees from the normal +z; negative ones on the other side of it.
glm::dvec3 at_degrees(double angle, double azimuth_degrees = 0) {
  const double a = angle * kPi / 180, b = azimuth_degrees * kPi / 180;
  return {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
}

/// I = kd Ia + Ip (kd (N.L) + ks (R.V)^n) with the notes' numbers: kd .4, Ia .2, Ip 1, ks .5, n 10.
double notes_example(const glm::dvec3& l, const glm::dvec3& v, double falloff, double (*highlight)(const LitPoint&, double) noexcept) {
  const LitPoint at{kUp, l, v};
  return 0.4 * 0.2 + falloff * (0.4 * diffuse_share(at) + 0.5 * highlight(at, 10));
}

/// The share of a uniformly white sky that is sent to the eye: the mean of `share` over the hemisphere, weighted
/// as light falling on a surface is not (the cosine is part of the share): (1/pi) times the integral.
double furnace(const glm::dvec3& to_eye, const std::function<double(const LitPoint&)>& share) {
  constexpr int kRings = 400, kSectors = 800;
  double sum = 0;
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kSectors; ++j) {
      const double theta = (i + 0.5) * kPi / 2 / kRings, phi = (j + 0.5) * 2 * kPi / kSectors;
      const glm::dvec3 l{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
      sum += share({kUp, l, to_eye}) * std::sin(theta);
    }
  return sum * (kPi / 2 / kRings) * (2 * kPi / kSectors) / kPi;
}

}  // namespace

TEST_CASE("reflection: the notes' example", "[math][B04][B07][B08][B12]") {
  const glm::dvec3 light{0.6, 0, 0.8}, mirror{-0.6, 0, 0.8};
  for (const auto highlight : {&phong_share, &blinn_phong_share}) {
    CHECK(notes_example(light, mirror, 1, highlight) == Approx(0.9).margin(1e-12));
    CHECK(notes_example(light, mirror, linear_falloff(3, 1), highlight) == Approx(0.285).margin(1e-12));
    CHECK(notes_example({0.6, 0, -0.8}, mirror, 1, highlight) == Approx(0.08).margin(1e-12));
  }
  CHECK(notes_example(light, kUp, 1, &phong_share) == Approx(0.4537).margin(1e-4));
}

TEST_CASE("reflection: only the side that faces the light reflects", "[math][B05]") {
  // Where R.V is negative there is no highlight, whatever its power would be.
  CHECK(phong_share({kUp, at_degrees(80), at_degrees(80)}, 2) == 0);
  for (const double angle : {90.0001, 120.0, 180.0}) {
    const LitPoint below{kUp, at_degrees(angle), at_degrees(-30)};
    CHECK(diffuse_share(below) == 0);
    CHECK(phong_share(below, 0) == 0);
    CHECK(blinn_phong_share(below, 3) == 0);
    CHECK(weighted_phong_share(below, 3, 1.5) == 0);
    CHECK(cook_torrance_share(below, {}, 1.5) == 0);
    CHECK(cook_torrance_share({kUp, at_degrees(30), at_degrees(angle)}, {}, 1.5) == 0);
  }
}

#ifndef NDEBUG
TEST_CASE("reflection: vectors that are not unit are caught in debug builds", "[math][B05]") {
  const auto dies = [](const LitPoint& at) {
    const pid_t child = fork();
    if (child == 0) {
      if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(2);
      std::signal(SIGABRT, SIG_DFL);
      static_cast<void>(diffuse_share(at));
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
  };
  CHECK(!dies({kUp, kUp, kUp}));
  CHECK(dies({kUp * 1.1, kUp, kUp}));
  CHECK(dies({kUp, {0.6, 0, 0.7}, kUp}));
  CHECK(dies({kUp, kUp, glm::dvec3(0)}));
}
#endif

TEST_CASE("reflection: falloff of light with distance", "[math][B09][B10]") {
  CHECK(linear_falloff(3, 1) == 0.25);
  CHECK(inverse_square_falloff(1) == Approx(1 / (4 * kPi)).epsilon(1e-15));
  for (const double d : {0.1, 1.0, 7.0}) CHECK(inverse_square_falloff(2 * d) == Approx(inverse_square_falloff(d) / 4).epsilon(1e-15));
}

TEST_CASE("reflection: a larger exponent makes a smaller highlight", "[math][B11][B12]") {
  // The angle at which cos^n is one half.
  double last = 90;
  for (const double n : {1.0, 3.0, 10.0, 50.0, 200.0}) {
    const double angle = std::acos(std::pow(0.5, 1 / n)) * 180 / kPi;
    CHECK(phong_share({kUp, at_degrees(20), at_degrees(-20 + angle)}, n) == Approx(0.5).epsilon(1e-9));
    CHECK(angle < last);
    last = angle;
  }
  // The perfect mirror: nothing is left a degree away.
  CHECK(phong_share({kUp, at_degrees(20), at_degrees(-21)}, 1e6) < 1e-60);
  CHECK(phong_share({kUp, at_degrees(20), at_degrees(-20)}, 1e6) == Approx(1).epsilon(1e-6));
}

TEST_CASE("reflection: Fresnel's share of glass, and the density of facets", "[math][B13][B42]") {
  const double table[][2] = {{0, .04000}, {30, .04152}, {45, .05024}, {56.31, .07396}, {60, .08919}, {80, .38770}, {89, .90418}};
  for (const auto& [angle, share] : table) {
    CHECK(fresnel_share(std::cos(angle * kPi / 180), 1.5) == Approx(share).margin(1e-4));
    // Fresnel's own equations, by the angles.
    CHECK(fresnel_share(std::cos(angle * kPi / 180), 1.5) == Approx(fresnel(std::cos(angle * kPi / 180), 1, 1.5).mean()).epsilon(1e-12));
  }
  CHECK(fresnel_share(0, 1.5) == 1);
  CHECK(fresnel_share(0.5, 0.5) == 1);  // beyond the critical angle
  for (const double c : {0.0, 0.3, 1.0}) CHECK(fresnel_share(c, 1) < 1e-30);
  CHECK(facet_density(FacetDistribution::beckmann, 1, 0.3) == Approx(11.1111).margin(1e-4));
  CHECK(facet_density(FacetDistribution::beckmann, std::cos(20 * kPi / 180), 0.3) == Approx(3.27009).margin(1e-4));
  CHECK(facet_density(FacetDistribution::gaussian, 1, 0.3) == Approx(1 / 0.09).epsilon(1e-12));
  CHECK(facet_density(FacetDistribution::gaussian, std::cos(0.3), 0.3) == Approx(std::exp(-1) / 0.09).epsilon(1e-12));
}

TEST_CASE("reflection: W(theta) makes glass a mirror at grazing incidence", "[math][B13]") {
  // In the mirror direction the power is 1 and W is left.
  double last = 0;
  for (const double angle : {1.0, 30.0, 60.0, 80.0, 89.0, 89.99}) {
    const double share = weighted_phong_share({kUp, at_degrees(angle), at_degrees(-angle)}, 50, 1.5);
    CHECK(share == Approx(fresnel(std::cos(angle * kPi / 180), 1, 1.5).mean()).epsilon(1e-9));
    CHECK(share > last);
    last = share;
  }
  CHECK(last > 0.99);
}

// In the plane of incidence, halfway vector along the normal: facets tilted by t let the light in unhidden until
// 2 cos t cos(theta_eye) < cos(theta_eye - t), and so on; three cases of [B Fig 24].
TEST_CASE("reflection: facets hide each other", "[math][B42]") {
  CHECK(shadowing_and_masking({kUp, at_degrees(30), at_degrees(-30)}) == 1);  // a: direct
  // c: the light is low, its facets stand in each other's shadow.  e: the eye is low, they mask each other.
  const LitPoint shadowed{kUp, at_degrees(85), at_degrees(0)}, masked{kUp, at_degrees(0), at_degrees(85)};
  const double half = std::cos(42.5 * kPi / 180), expected = 2 * half * std::cos(85 * kPi / 180) / half;
  CHECK(shadowing_and_masking(shadowed) == Approx(expected).epsilon(1e-12));
  CHECK(shadowing_and_masking(masked) == Approx(expected).epsilon(1e-12));
  for (double light = 0; light < 90; light += 7.3)
    for (double eye = -89; eye < 90; eye += 7.1)
      for (double azimuth = 0; azimuth < 180; azimuth += 31) {
        const double g = shadowing_and_masking({kUp, at_degrees(light, azimuth), at_degrees(eye)});
        CHECK((g >= 0 && g <= 1));
      }
}

TEST_CASE("reflection: Cook-Torrance as printed and as derived later", "[math][B42]") {
  ReflectionConstants printed{.model = Reflection::cook_torrance, .roughness = 0.3f}, later = printed;
  later.divided_by_pi = false;
  const LitPoint at{kUp, at_degrees(40), at_degrees(-30)};
  const glm::dvec3 h = glm::normalize(at.to_light + at.to_eye);
  // ks (N.L) = D G F / (pi (N.V)), every factor by its own formula; m is a float.
  const double m = static_cast<double>(0.3f), alpha = 5 * kPi / 180;
  const double d = std::exp(-std::pow(std::tan(alpha) / m, 2)) / (m * m * std::pow(std::cos(alpha), 4));
  const double f = fresnel(glm::dot(h, at.to_eye), 1, 1.5).mean();
  CHECK(cook_torrance_share(at, printed, 1.5) == Approx(d * f / (kPi * std::cos(30 * kPi / 180))).epsilon(1e-9));
  CHECK(cook_torrance_share(at, printed, 1.5) / cook_torrance_share(at, later, 1.5) == Approx(4 / kPi).epsilon(1e-12));
  // The Gaussian facets of a smooth surface are Beckmann's.
  ReflectionConstants gaussian = later;
  gaussian.facets = FacetDistribution::gaussian;
  gaussian.roughness = later.roughness = 0.02f;
  const LitPoint near{kUp, at_degrees(31), at_degrees(-30)};
  CHECK(cook_torrance_share(near, gaussian, 1.5) == Approx(cook_torrance_share(near, later, 1.5)).epsilon(1e-3));
}

TEST_CASE("reflection: highlights of Phong and Cook-Torrance agree for small angles only", "[math][B43]") {
  // In the mirror direction Phong's highlight is the same at every angle; Cook-Torrance's grows as Fresnel's share does.
  const ReflectionConstants rough{.model = Reflection::cook_torrance, .roughness = 0.2f};
  const auto share = [&](double angle) { return cook_torrance_share({kUp, at_degrees(angle), at_degrees(-angle)}, rough, 1.5); };
  const double straight = share(0.01);
  CHECK(share(10) == Approx(straight).epsilon(0.03));
  CHECK(share(80) > 10 * straight);
  double last = 0;
  for (double angle = 10; angle <= 80; angle += 10) {
    CHECK(phong_share({kUp, at_degrees(angle), at_degrees(-angle)}, 50) == Approx(1).epsilon(1e-12));
    const double difference = std::abs(share(angle) / straight - 1);
    CHECK(difference > last);
    last = difference;
  }
}

TEST_CASE("reflection: the highlight of a metal is coloured, Phong's is not", "[math][B17][B43]") {
  ReflectionConstants copper{.model = Reflection::cook_torrance, .diffuse = glm::vec3(0), .specular = glm::vec3(1)};
  copper.refractive_index = {8, 3, 2};  // reflects red best
  const LitPoint at{kUp, at_degrees(20), at_degrees(-20)};
  const glm::dvec3 metal = reflected_share(copper, at);
  CHECK((metal.r > metal.g && metal.g > metal.b));
  copper.model = Reflection::phong;
  CHECK(reflected_share(copper, at) == glm::dvec3(1));
}

// Energy: light of intensity 1 from everywhere. Lambert sends kd of it on. Phong's share has no factor N.L and integrates to
// 2/(n+1) at most, so that ks may be 1 for n >= 1; times N.L it needs (n+2)/2 to be 1 at normal incidence.
TEST_CASE("reflection: a white furnace", "[math][furnace]") {
  for (const double eye : {0.0, 35.0, 70.0, 85.0}) {
    INFO("the eye at " << eye << " degrees");
    const glm::dvec3 v = at_degrees(eye);
    CHECK(0.7 * furnace(v, diffuse_share) == Approx(0.7).epsilon(1e-4));
    for (const double n : {1.0, 10.0, 100.0}) {
      INFO("exponent " << n);
      const double phong = furnace(v, [&](const LitPoint& at) { return phong_share(at, n); });
      const double normalized = furnace(v, [&](const LitPoint& at) { return (n + 2) / 2 * phong_share(at, n) * diffuse_share(at); });
      if (eye == 0) {
        CHECK(phong == Approx(2 / (n + 1)).epsilon(1e-3));
        CHECK(normalized == Approx(1).epsilon(1e-3));
        // H is tilted half as far as L: 8/(n+2) (1 - 2^(-(n+2)/2)).
        CHECK(furnace(v, [&](const LitPoint& at) { return blinn_phong_share(at, n); }) ==
              Approx(8 / (n + 2) * (1 - std::pow(2, -(n + 2) / 2))).epsilon(1e-3));
      }
      CHECK(phong <= 2 / (n + 1) * 1.001);
      CHECK(normalized <= 1.001);
      CHECK(furnace(v, [&](const LitPoint& at) { return blinn_phong_share(at, n); }) <= 8 / (n + 1));
      CHECK(furnace(v, [&](const LitPoint& at) { return weighted_phong_share(at, n, 1.5); }) <= phong);
    }
  }
}

// Facets that reflect all light, whatever their tilt: the form with 4 loses energy to shadowing, the notes' gains up to 4/pi.
TEST_CASE("reflection: a white furnace of facets", "[math][furnace][B42]") {
  for (const FacetDistribution facets : {FacetDistribution::beckmann, FacetDistribution::gaussian})
    for (const float m : {0.1f, 0.3f, 0.6f})
      for (const double eye : {0.0, 35.0, 70.0, 85.0}) {
        INFO("roughness " << m << ", the eye at " << eye << " degrees, facets " << static_cast<int>(facets));
        const ReflectionConstants later{.model = Reflection::cook_torrance, .roughness = m, .facets = facets, .divided_by_pi = false};
        const double share = furnace(at_degrees(eye), [&](const LitPoint& at) { return cook_torrance_share(at, later, 1e3); });
        CHECK(share <= 1.001);
        if (m == 0.1f && eye < 40) CHECK(share > 0.97);
        // Of glass little is left for the highlight, so that diffuse light has room in either form.
        CHECK(furnace(at_degrees(eye), [&](const LitPoint& at) { return cook_torrance_share(at, later, 1.5); }) * 4 / kPi < 0.75);
      }
}

}  // namespace tuberia
