#pragma once
// Light by wavelengths, and the colour that it has for an eye and on a monitor.              [B 2.9]

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace tuberia {

inline constexpr double kShortestWavelength = 380, kLongestWavelength = 780;  // nanometres

/// The colour matching functions (x, y, z) of the 1931 standard observer, 2 degrees, at a wavelength in
/// nanometres: linear between the table's values every 10 nm, 0 outside 380 to 780.           [CIE1931]
glm::dvec3 colour_matching(double wavelength) noexcept;

/// The matrix of the sRGB monitor: from its primaries and white, D65.                         [IEC61966]
glm::dmat3 xyz_from_linear_srgb() noexcept;

/// Multiplies XYZ so that one white becomes another as an eye adapts: each of three cone responses by a
/// factor of its own. Both whites: XYZ with positive responses.                               [Bradford]
glm::dmat3 adaptation(const glm::dvec3& from_white, const glm::dvec3& into_white) noexcept;

/// `count` wavelengths at equal steps from 380 to 780 nm; count >= 3.
std::vector<double> equal_wavelengths(int count);

/// For each wavelength the linear sRGB of a unit of light there: the colour of light L is the sum of
/// weight[i] L[i]. The eye is adapted to `white`, so that the light `white` has the colour (1, 1, 1).
/// wavelengths: at equal steps, within 380 to 780.   white: as many, not negative, of some visible light.
std::vector<glm::dvec3> linear_srgb_weights(std::span<const double> wavelengths, std::span<const double> white);

}  // namespace tuberia
