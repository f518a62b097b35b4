#include "scene/spectral_image.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "math/spectrum.hpp"
#include "scene/spectral_surface.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/lit_triangle.hpp"

namespace tuberia {

namespace {

using Spectrum = std::vector<double>;

const Spectrum kWavelengths = equal_wavelengths(41), kEqualEnergy(41, 1.0);

/// Of a glowing filament, roughly: ever more towards the red.
Spectrum warm_light() {
  Spectrum light;
  for (const double wavelength : kWavelengths) light.push_back(0.1 + 1.8 * (wavelength - 380) / 400);
  return light;
}

/// A surface of this reflectance under this light, drawn band by band by the surface program.
Rgba32F drawn(const Spectrum& reflectance, const Spectrum& light, const Spectrum& white, InstructionSet set, Precision precision) {
  const test::LitTriangle flat{.size = 4};
  SpectralImage image = *SpectralImage::create(4, 4, kWavelengths, white);
  for (int band = 0; band < image.band_count(); ++band) {
    SpectralSurface spectral{.surface = {.reflection = {.model = Reflection::lambert}, .ambient_light = glm::vec3(0), .lights = {SurfaceLight{}}},
                             .diffuse = reflectance, .intensities = {light}};
    REQUIRE(image.add(band, flat.picture(surface(surface_of_band(spectral, band)), set, precision)).ok());
  }
  return image.linear_srgb().at(1, 2);
}

double product(const Spectrum& a, const std::vector<glm::dvec3>& weights, int channel) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * weights[i][channel];
  return sum;
}

/// Another spectrum of the same colour under light of equal energy: `like` and a wave of which all is
/// taken away that an eye would notice.
Spectrum metamer_of(const Spectrum& like) {
  const std::vector<glm::dvec3> weights = linear_srgb_weights(kWavelengths, kEqualEnergy);
  // What the eye notices is spanned by the weights' three rows; made orthogonal one after the other.
  std::array<Spectrum, 3> rows;
  Spectrum wave;
  const auto dot_of = [](const Spectrum& a, const Spectrum& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  };
  const auto take_away = [&](Spectrum& from, const Spectrum& row) {
    const double share = dot_of(from, row) / dot_of(row, row);
    for (std::size_t i = 0; i < from.size(); ++i) from[i] -= share * row[i];
  };
  for (const double wavelength : kWavelengths) wave.push_back(std::cos(wavelength / 25));
  for (std::size_t c = 0; c < 3; ++c) {
    for (const glm::dvec3& weight : weights) rows[c].push_back(weight[static_cast<int>(c)]);
    for (std::size_t before = 0; before < c; ++before) take_away(rows[c], rows[before]);
    take_away(wave, rows[c]);
  }
  Spectrum metamer = like;
  for (std::size_t i = 0; i < wave.size(); ++i) metamer[i] += 0.4 * wave[i];
  return metamer;
}

}  // namespace

TEST_CASE("spectral: white light on a white surface is white", "[surfaces][B19]") {
  test::for_every_machine([](InstructionSet set, Precision precision) {
    for (const Spectrum& light : {kEqualEnergy, warm_light()}) {  // to each of which the eye is adapted
      const Rgba32F white = drawn(kEqualEnergy, light, light, set, precision);
      for (int c = 0; c < 3; ++c) CHECK(test::channel(white, c) == Approx(1).margin(1e-3));
    }
  });
}

TEST_CASE("spectral: two surfaces alike in one light differ in another", "[surfaces][B19]") {
  const Spectrum grey(41, 0.5), metamer = metamer_of(grey);
  for (const double share : metamer) REQUIRE((share >= 0 && share <= 1));
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    const Rgba32F a = drawn(grey, kEqualEnergy, kEqualEnergy, set, precision), b = drawn(metamer, kEqualEnergy, kEqualEnergy, set, precision);
    double apart = 0;
    const Rgba32F warm_a = drawn(grey, warm_light(), kEqualEnergy, set, precision), warm_b = drawn(metamer, warm_light(), kEqualEnergy, set, precision);
    for (int c = 0; c < 3; ++c) {
      CHECK(test::channel(a, c) == Approx(test::channel(b, c)).margin(1e-4));
      apart = std::max(apart, std::abs(test::channel(warm_a, c) - test::channel(warm_b, c)));
    }
    CHECK(apart > 0.02);
  });
}

// Three channels alone cannot know what a narrow band of light does.
TEST_CASE("spectral: light of one wavelength shows its colour only", "[surfaces][B19]") {
  Spectrum sodium(41, 0.0);
  sodium[21] = 20;  // 590 nm
  const Rgba32F colour = drawn(kEqualEnergy, sodium, kEqualEnergy, InstructionSet::baseline, Precision::exact);
  const auto weights = linear_srgb_weights(kWavelengths, kEqualEnergy);
  for (int c = 0; c < 3; ++c) CHECK(test::channel(colour, c) == Approx(product(sodium, weights, c)).epsilon(1e-5));
  CHECK((colour.r > 0.5f && colour.b < 0));  // redder than the monitor's red and green can be
}

// The refractive index of a prism's glass falls with the wavelength: its highlight is bluish, for the same kd.
TEST_CASE("spectral: a refractive index by wavelengths colours the highlight", "[surfaces][B19][B43]") {
  const test::LitTriangle flat{.size = 4};
  SpectralSurface glass{.surface = {.reflection = {.model = Reflection::cook_torrance, .diffuse = glm::vec3(0), .specular = glm::vec3(1)},
                                    .ambient_light = glm::vec3(0), .lights = {SurfaceLight{}}, .eye = {0, 0, 1e6f}},
                        .intensities = {kEqualEnergy}};
  for (const double wavelength : kWavelengths) glass.refractive_index.push_back(1.2 + 3e5 / (wavelength * wavelength));
  const auto drawn_with = [&](const SpectralSurface& surface_by_wavelengths) {
    SpectralImage image = *SpectralImage::create(4, 4, kWavelengths, kEqualEnergy);
    for (int band = 0; band < image.band_count(); ++band)
      REQUIRE(image.add(band, flat.picture(surface(surface_of_band(surface_by_wavelengths, band)), InstructionSet::baseline, Precision::exact)).ok());
    return image.linear_srgb().at(1, 1);
  };
  const Rgba32F coloured = drawn_with(glass);
  CHECK((coloured.b > 1.2f * coloured.g && coloured.g > 1.05f * coloured.r));
  glass.refractive_index.clear();
  const Rgba32F grey = drawn_with(glass);
  CHECK(grey.r == Approx(grey.b).epsilon(1e-4));
}

TEST_CASE("spectral: what is no spectrum is refused", "[surfaces][B19]") {
  using Catch::Matchers::Contains;
  const auto refusal = [](const Spectrum& wavelengths, const Spectrum& white) {
    const auto image = SpectralImage::create(2, 2, wavelengths, white);
    return image ? "accepted" : image.error().message;
  };
  CHECK(refusal(kWavelengths, kEqualEnergy) == "accepted");
  CHECK_THAT(refusal({400, 500}, {1, 1}), Contains("2 wavelengths"));
  CHECK_THAT(refusal({400, 500, 600}, {1, 1}), Contains("3 wavelengths, but 2"));
  CHECK_THAT(refusal({400, 500, 900}, {1, 1, 1}), Contains("wavelength 2 is 900") && Contains("380 to 780"));
  CHECK_THAT(refusal({400, 500, 600}, {1, -1, 1}), Contains("-1") && Contains("wavelength 1"));
  CHECK_THAT(refusal({400, 500, 600}, {0, 0, 0}), Contains("adapt"));
  SpectralImage image = *SpectralImage::create(2, 2, kWavelengths, kEqualEnergy);
  CHECK_THAT(image.add(14, Image<Rgba32F>(2, 2)).error().message, Contains("band 14 of 14"));
  CHECK_THAT(image.add(0, Image<Rgba32F>(3, 2)).error().message, Contains("3x2"));
  CHECK(band_of(Spectrum{1, 2, 3, 4}, 1, 7) == glm::vec3(4, 7, 7));
}

}  // namespace tuberia
