#include "math/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "base/assertion.hpp"

namespace tuberia {
namespace {

constexpr double kTableStep = 10;
constexpr std::array<glm::dvec3, 41> kColourMatching{{
    {0.001368, 0.000039, 0.006450}, {0.004243, 0.000120, 0.020050}, {0.014310, 0.000396, 0.067850}, {0.043510, 0.001210, 0.207400},
    {0.134380, 0.004000, 0.645600}, {0.283900, 0.011600, 1.385600}, {0.348280, 0.023000, 1.747060}, {0.336200, 0.038000, 1.772110},
    {0.290800, 0.060000, 1.669200}, {0.195360, 0.090980, 1.287640}, {0.095640, 0.139020, 0.812950}, {0.032010, 0.208020, 0.465180},
    {0.004900, 0.323000, 0.272000}, {0.009300, 0.503000, 0.158200}, {0.063270, 0.710000, 0.078250}, {0.165500, 0.862000, 0.042160},
    {0.290400, 0.954000, 0.020300}, {0.433450, 0.994950, 0.008750}, {0.594500, 0.995000, 0.003900}, {0.762100, 0.952000, 0.002100},
    {0.916300, 0.870000, 0.001650}, {1.026300, 0.757000, 0.001100}, {1.062200, 0.631000, 0.000800}, {1.002600, 0.503000, 0.000340},
    {0.854450, 0.381000, 0.000190}, {0.642400, 0.265000, 0.000050}, {0.447900, 0.175000, 0.000020}, {0.283500, 0.107000, 0},
    {0.164900, 0.061000, 0}, {0.087400, 0.032000, 0}, {0.046770, 0.017000, 0}, {0.022700, 0.008210, 0},
    {0.011359, 0.004102, 0}, {0.005790, 0.002091, 0}, {0.002899, 0.001047, 0}, {0.001440, 0.000520, 0},
    {0.000690, 0.000249, 0}, {0.000332, 0.000120, 0}, {0.000166, 0.000060, 0}, {0.000083, 0.000030, 0}, {0.000042, 0.000015, 0},
}};

/// The colour of chromaticity (x, y) with Y = 1.
glm::dvec3 xyz_of(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

const glm::dvec3 kD65 = xyz_of(0.3127, 0.3290);

/// The cones' responses to XYZ; glm's matrices are given by columns.
const glm::dmat3 kConesFromXyz{{0.8951, -0.7502, 0.0389}, {0.2664, 1.7135, -0.0685}, {-0.1614, 0.0367, 1.0296}};

}  // namespace

glm::dvec3 colour_matching(double wavelength) noexcept {
  if (!(wavelength >= kShortestWavelength && wavelength <= kLongestWavelength)) return glm::dvec3(0);
  const double place = (wavelength - kShortestWavelength) / kTableStep;
  const auto i = std::min(static_cast<std::size_t>(place), kColourMatching.size() - 2);
  return glm::mix(kColourMatching[i], kColourMatching[i + 1], place - static_cast<double>(i));
}

glm::dmat3 xyz_from_linear_srgb() noexcept {
  const glm::dmat3 primaries{xyz_of(0.64, 0.33), xyz_of(0.30, 0.60), xyz_of(0.15, 0.06)};
  const glm::dvec3 strengths = glm::inverse(primaries) * kD65;  // that together are white
  return {primaries[0] * strengths.x, primaries[1] * strengths.y, primaries[2] * strengths.z};
}

glm::dmat3 adaptation(const glm::dvec3& from_white, const glm::dvec3& into_white) noexcept {
  const glm::dvec3 factors = (kConesFromXyz * into_white) / (kConesFromXyz * from_white);
  const glm::dmat3 scaled{{factors.x, 0, 0}, {0, factors.y, 0}, {0, 0, factors.z}};
  return glm::inverse(kConesFromXyz) * scaled * kConesFromXyz;
}

std::vector<double> equal_wavelengths(int count) {
  TUBERIA_ASSERT(count >= 3, "three wavelengths at least make a colour");
  std::vector<double> wavelengths;
  for (int i = 0; i < count; ++i)
    wavelengths.push_back(kShortestWavelength + (kLongestWavelength - kShortestWavelength) * i / (count - 1));
  return wavelengths;
}

std::vector<glm::dvec3> linear_srgb_weights(std::span<const double> wavelengths, std::span<const double> white) {
  TUBERIA_ASSERT(wavelengths.size() == white.size(), "the white has a value for each wavelength");
  glm::dvec3 xyz_of_white(0);
  for (std::size_t i = 0; i < white.size(); ++i) xyz_of_white += white[i] * colour_matching(wavelengths[i]);
  const glm::dmat3 colour_from_xyz = glm::inverse(xyz_from_linear_srgb()) * adaptation(xyz_of_white, kD65);
  std::vector<glm::dvec3> weights;
  for (const double wavelength : wavelengths) weights.push_back(colour_from_xyz * colour_matching(wavelength));
  return weights;
}

}  // namespace tuberia
