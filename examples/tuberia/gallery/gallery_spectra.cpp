#include "examples/tuberia/gallery/gallery_spectra.hpp"

#include <array>
#include <cmath>

#include "math/spectrum.hpp"
#include "math/transforms.hpp"
#include "scene/content/develop.hpp"
#include "scene/mesh_view.hpp"
#include "scene/shapes/shapes.hpp"
#include "scene/spectral_image.hpp"
#include "scene/spectral_surface.hpp"

namespace tuberia::cli {
namespace {

using Spectrum = std::vector<double>;

constexpr int kWavelengths = 41, kWidth = 480, kHeight = 480;

double dot_of(const Spectrum& a, const Spectrum& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

void take_away(Spectrum& from, const Spectrum& row) {
  const double share = dot_of(from, row) / dot_of(row, row);
  for (std::size_t i = 0; i < from.size(); ++i) from[i] -= share * row[i];
}

/// A reflectance that looks as `like` does in a light: with a wave of which all is taken away that an eye notices.
Spectrum metamer_of(const Spectrum& like, const Spectrum& wavelengths, const Spectrum& light) {
  const std::vector<glm::dvec3> weights = linear_srgb_weights(wavelengths, light);
  Spectrum wave;
  for (const double wavelength : wavelengths) wave.push_back(std::cos(wavelength / 25));
  std::array<Spectrum, 3> noticed;
  for (int c = 0; c < 3; ++c) {
    Spectrum& row = noticed[static_cast<std::size_t>(c)];
    for (std::size_t i = 0; i < wavelengths.size(); ++i) row.push_back(weights[i][c] * light[i]);
    for (int before = 0; before < c; ++before) take_away(row, noticed[static_cast<std::size_t>(before)]);
    take_away(wave, row);
  }
  Spectrum metamer = like;
  for (std::size_t i = 0; i < wave.size(); ++i) metamer[i] += 0.45 * wave[i];
  return metamer;
}

/// Four spheres of one band: columns differ in their reflectance, rows in their light.
Result<Image<Rgba32F>> draw_band(const Mesh& sphere, const std::array<Spectrum, 2>& reflectances, const std::array<Spectrum, 2>& lights, int band, Pipeline& pipeline) {
  auto target = RenderTarget::create({.width = kWidth, .height = kHeight, .colour = ColourFormat::rgba32f, .samples = 4});
  if (!target) return target.error();
  pipeline.clear(*target, {0, 0, 0, 1});
  SurfaceLight lamp;
  lamp.light.towards = glm::normalize(glm::vec3(-0.6f, 0.7f, 1));
  for (std::size_t row = 0; row < 2; ++row)
    for (std::size_t column = 0; column < 2; ++column) {
      const SpectralSurface surface_by_wavelengths{.surface = {.reflection = {.model = Reflection::lambert}, .ambient_light = glm::vec3(0), .lights = {lamp}, .eye = {0, 0, 1e6f}},
                                                   .diffuse = reflectances[column], .intensities = {lights[row]}};
      DrawCall draw;
      draw.mesh = mesh_view(sphere);
      draw.program = surface(surface_of_band(surface_by_wavelengths, band));
      draw.state.transform.world_from_object = translation({column == 0 ? -1.1 : 1.1, row == 0 ? 1.1 : -1.1, 0});
      draw.state.transform.clip_from_world = scaling({1 / 2.3, 1 / 2.3, -0.1});
      if (const auto drawn = pipeline.draw(*target, draw); !drawn) return drawn.error();
    }
  return target->linear_image();
}

}  // namespace

Result<Image<Rgba8>> draw_metamers(const std::filesystem::path&, Pipeline& pipeline) {
  const auto sphere = sphere_mesh({.slices = 64, .stacks = 32});
  if (!sphere) return sphere.error();
  const Spectrum wavelengths = equal_wavelengths(kWavelengths), white(kWavelengths, 1.0), grey(kWavelengths, 0.5);
  // As of a lamp: ever more towards the red.
  Spectrum warm;
  for (const double wavelength : wavelengths) warm.push_back(0.15 + 1.5 * (wavelength - kShortestWavelength) / (kLongestWavelength - kShortestWavelength));
  auto image = SpectralImage::create(kWidth, kHeight, wavelengths, white);
  if (!image) return image.error();
  for (int band = 0; band < image->band_count(); ++band) {
    const auto picture = draw_band(*sphere, {grey, metamer_of(grey, wavelengths, white)}, {white, warm}, band, pipeline);
    if (!picture) return picture.error();
    if (const auto added = image->add(band, *picture); !added) return added.error();
  }
  return srgb_codes_of(developed(image->linear_srgb(), {}));
}

}  // namespace tuberia::cli
