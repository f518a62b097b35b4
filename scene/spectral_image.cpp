#include "scene/spectral_image.hpp"

#include <cmath>

#include "math/spectrum.hpp"

namespace tuberia {
namespace {

std::size_t first_of(int band) { return static_cast<std::size_t>(band) * 3; }

}  // namespace

glm::vec3 band_of(std::span<const double> spectrum, int band, float missing) noexcept {
  glm::vec3 values(missing);
  for (std::size_t i = 0; i < 3 && first_of(band) + i < spectrum.size(); ++i)
    values[static_cast<int>(i)] = static_cast<float>(spectrum[first_of(band) + i]);
  return values;
}

Result<SpectralImage> SpectralImage::create(int width, int height, std::span<const double> wavelengths, std::span<const double> white) {
  if (wavelengths.size() != white.size())
    return Error{"there are " + std::to_string(wavelengths.size()) + " wavelengths, but " + std::to_string(white.size()) + " values of the white"};
  if (wavelengths.size() < 3) return Error{"there are " + std::to_string(wavelengths.size()) + " wavelengths; three at least make a colour"};
  for (std::size_t i = 0; i < wavelengths.size(); ++i) {
    if (!(wavelengths[i] >= kShortestWavelength && wavelengths[i] <= kLongestWavelength))
      return Error{"wavelength " + std::to_string(i) + " is " + std::to_string(wavelengths[i]) + " nm, outside 380 to 780"};
    if (!(white[i] >= 0) || !std::isfinite(white[i]))
      return Error{"the white is " + std::to_string(white[i]) + " at wavelength " + std::to_string(i) + "; it must be finite and not negative"};
  }
  SpectralImage image;
  image.width_ = width, image.height_ = height;
  image.weights_ = linear_srgb_weights(wavelengths, white);
  for (const glm::dvec3& weight : image.weights_)
    if (!std::isfinite(weight.x + weight.y + weight.z)) return Error{"the white has no light that an eye can adapt to"};
  image.sums_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), glm::dvec3(0));
  image.alphas_.assign(image.sums_.size(), 1.0f);
  return image;
}

Result<Nothing> SpectralImage::add(int band, const Image<Rgba32F>& picture) {
  if (band < 0 || band >= band_count()) return Error{"band " + std::to_string(band) + " of " + std::to_string(band_count())};
  if (picture.width() != width_ || picture.height() != height_)
    return Error{"the band's picture has " + std::to_string(picture.width()) + "x" + std::to_string(picture.height()) + " pixels, the others " +
                 std::to_string(width_) + "x" + std::to_string(height_)};
  const std::span<const glm::dvec3> weights = std::span(weights_).subspan(first_of(band));
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const Rgba32F& pixel = picture.pixels()[i];
    const double light[3] = {static_cast<double>(pixel.r), static_cast<double>(pixel.g), static_cast<double>(pixel.b)};
    for (std::size_t k = 0; k < 3 && k < weights.size(); ++k) sums_[i] += weights[k] * light[k];
    if (band == 0) alphas_[i] = pixel.a;
  }
  return Nothing{};
}

Image<Rgba32F> SpectralImage::linear_srgb() const {
  Image<Rgba32F> image(width_, height_);
  for (std::size_t i = 0; i < sums_.size(); ++i)
    image.pixels()[i] = {static_cast<float>(sums_[i].r), static_cast<float>(sums_[i].g), static_cast<float>(sums_[i].b), alphas_[i]};
  return image;
}

}  // namespace tuberia
