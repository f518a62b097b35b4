#pragma once
// A surface and its lights by wavelengths, as the three of a band that the surface program draws at a time.

#include <vector>

#include "pipeline/programs/surface.hpp"

namespace tuberia {

/// Spectra have a value for each wavelength of a SpectralImage; an empty one leaves what `surface` says.
struct SpectralSurface {
  SurfaceUniforms surface{};                     // all that does not depend on the wavelength
  std::vector<double> ambient{}, diffuse{}, specular{}, refractive_index{}, ambient_light{};
  std::vector<std::vector<double>> intensities{};  // of the surface's lights, in their order; may end earlier
};

/// The surface that draws a band: the wavelengths 3 band, 3 band + 1 and 3 band + 2 as red, green and blue.
SurfaceUniforms surface_of_band(const SpectralSurface& spectral, int band);

}  // namespace tuberia
