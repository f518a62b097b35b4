#include "scene/spectral_surface.hpp"

#include <algorithm>

#include "scene/spectral_image.hpp"

namespace tuberia {
namespace {

void take_band(const std::vector<double>& spectrum, int band, glm::vec3& value, float missing = 0) {
  if (!spectrum.empty()) value = band_of(spectrum, band, missing);
}

}  // namespace

SurfaceUniforms surface_of_band(const SpectralSurface& spectral, int band) {
  SurfaceUniforms surface = spectral.surface;
  take_band(spectral.ambient, band, surface.reflection.ambient);
  take_band(spectral.diffuse, band, surface.reflection.diffuse);
  take_band(spectral.specular, band, surface.reflection.specular);
  take_band(spectral.refractive_index, band, surface.reflection.refractive_index, 1);  // 0 would be refused
  take_band(spectral.ambient_light, band, surface.ambient_light);
  const std::size_t lights = std::min(spectral.intensities.size(), surface.lights.size());
  for (std::size_t i = 0; i < lights; ++i) take_band(spectral.intensities[i], band, surface.lights[i].light.intensity);
  return surface;
}

}  // namespace tuberia
