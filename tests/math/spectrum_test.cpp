#include "math/spectrum.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <glm/matrix.hpp>

namespace tuberia {

namespace {

glm::dvec3 colour_of(std::span<const glm::dvec3> weights, std::span<const double> light) {
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < light.size(); ++i) sum += weights[i] * light[i];
  return sum;
}

}  // namespace

// Chromaticities of single wavelengths, published beside the functions themselves.               [CIE1931]
TEST_CASE("spectrum: the colour matching functions give the known spectral locus", "[math][B19]") {
  const double locus[][3] = {{450, .1566, .0177}, {470, .1241, .0578}, {490, .0454, .2950}, {510, .0139, .7502}, {520, .0743, .8338},
                             {540, .2296, .7543}, {580, .5125, .4866}, {600, .6270, .3725}, {620, .6915, .3083}, {700, .7347, .2653}};
  for (const auto& [wavelength, x, y] : locus) {
    const glm::dvec3 xyz = colour_matching(wavelength);
    CHECK(xyz.x / (xyz.x + xyz.y + xyz.z) == Approx(x).margin(6e-5));
    CHECK(xyz.y / (xyz.x + xyz.y + xyz.z) == Approx(y).margin(6e-5));
  }
  // Light of equal energy is white: x, y and z have the same integral, 106.86 with steps of a nanometre.
  glm::dvec3 sum(0);
  for (const double wavelength : equal_wavelengths(41)) sum += colour_matching(wavelength) * 10.0;
  for (int i = 0; i < 3; ++i) CHECK(sum[i] == Approx(106.86).epsilon(1.5e-3));
  CHECK(colour_matching(379.9) == glm::dvec3(0));
  CHECK(colour_matching(780.1) == glm::dvec3(0));
  CHECK(colour_matching(555).y == Approx(0.5 * (0.99495 + 0.995)).epsilon(1e-12));
}

TEST_CASE("spectrum: the monitor's matrix is the standard's", "[math][B19]") {
  const glm::dmat3 rgb_from_xyz = glm::inverse(xyz_from_linear_srgb());
  const double standard[3][3] = {{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) CHECK(rgb_from_xyz[column][row] == Approx(standard[row][column]).margin(5e-4));
}

TEST_CASE("spectrum: an eye adapts to any white, and to none that it is adapted to", "[math][B19]") {
  const glm::dvec3 equal_energy(1), d65{0.9505, 1, 1.0888};
  const glm::dvec3 adapted = adaptation(equal_energy, d65) * equal_energy;
  for (int i = 0; i < 3; ++i) CHECK(adapted[i] == Approx(d65[i]).epsilon(1e-12));
  const glm::dmat3 same = adaptation(d65, d65);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) CHECK(same[i][k] == Approx(i == k ? 1 : 0).margin(1e-12));
}

TEST_CASE("spectrum: white light is white with any number of wavelengths", "[math][B19]") {
  for (const int count : {3, 7, 21, 41, 100}) {
    const std::vector<double> wavelengths = equal_wavelengths(count), equal(static_cast<std::size_t>(count), 0.4);
    CHECK(wavelengths.front() == 380);
    CHECK(wavelengths.back() == 780);
    if (count == 3) continue;  // one wavelength of three is one that an eye sees
    const glm::dvec3 colour = colour_of(linear_srgb_weights(wavelengths, equal), equal);
    for (int i = 0; i < 3; ++i) CHECK(colour[i] == Approx(1).epsilon(1e-9));
  }
  // Long wavelengths are red, short ones blue, and what lies between is green.
  const std::vector<double> wavelengths = equal_wavelengths(41), equal(41, 1.0);
  const auto weights = linear_srgb_weights(wavelengths, equal);
  const auto light_between = [&](double from, double to) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < wavelengths.size(); ++i)
      if (wavelengths[i] >= from && wavelengths[i] <= to) sum += weights[i];
    return sum;
  };
  const glm::dvec3 red = light_between(620, 780), green = light_between(510, 560), blue = light_between(380, 480);
  CHECK((red.r > 0.5 && red.g < 0.1 && std::abs(red.b) < 0.1));
  CHECK((green.g > 0.5 && green.r < 0.1 && green.b < 0.1));
  CHECK((blue.b > 0.5 && blue.g < 0.1));
}

}  // namespace tuberia
