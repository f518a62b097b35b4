#pragma once
// Pictures of more wavelengths than three: drawn three at a time through the red, green and blue of the
// usual programs, and summed to the colours that they have together.                          [B 2.9]

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "image/image.hpp"

namespace tuberia {

/// How many pictures of three wavelengths each there are; the last one may have some to spare.
constexpr int band_count(std::size_t wavelengths) noexcept { return static_cast<int>((wavelengths + 2) / 3); }

/// The three values of a band of a spectrum (a reflectance, a refractive index, a light's intensity), for a
/// program's red, green and blue; `missing` beyond the spectrum's end.
glm::vec3 band_of(std::span<const double> spectrum, int band, float missing = 0) noexcept;

/// The sum of a picture's bands.
class SpectralImage {
 public:
  /// wavelengths, white: as linear_srgb_weights takes them; what looks white is drawn as (1, 1, 1).
  /// Error for lists of different lengths, fewer than three wavelengths, or one outside 380 to 780 nm.
  static Result<SpectralImage> create(int width, int height, std::span<const double> wavelengths, std::span<const double> white);

  int band_count() const noexcept { return tuberia::band_count(weights_.size()); }

  /// Adds the picture of a band. Error for a band that is not there, or another size.
  Result<Nothing> add(int band, const Image<Rgba32F>& picture);

  /// Linear sRGB, for an eye that is adapted to the white. What no monitor can show has a channel below 0 or above
  /// 1. Alpha is the first band's.
  Image<Rgba32F> linear_srgb() const;

 private:
  SpectralImage() = default;
  int width_ = 0, height_ = 0;
  std::vector<glm::dvec3> weights_, sums_;
  std::vector<float> alphas_;
};

}  // namespace tuberia
