#include "scene/content/develop.hpp"

#include <algorithm>
#include <cmath>

#include "image/exposure.hpp"
#include "math/colour.hpp"

namespace tuberia {
namespace {

/// NaN gives 0, and so does what is below it.
float at_least_0(float value) { return value > 0 ? value : 0; }
float clamped(float value) { return std::min(at_least_0(value), 1.0f); }

/// Each pixel's channels keep their proportions.
Rgba32F scaled_to_range(const Rgba32F& pixel) {
  const Rgba32F positive{at_least_0(pixel.r), at_least_0(pixel.g), at_least_0(pixel.b), pixel.a};
  const float largest = std::max({positive.r, positive.g, positive.b});
  if (!(largest > 1) || !std::isfinite(largest)) return positive;
  return {positive.r / largest, positive.g / largest, positive.b / largest, positive.a};
}

}  // namespace

Image<Rgba32F> developed(Image<Rgba32F> light, const description::Picture& picture) {
  if (picture.exposure_stops != 0) expose(light, static_cast<float>(std::exp2(picture.exposure_stops)));
  if (picture.overflow == description::Overflow::global_scale) scale_to_range(light);
  for (Rgba32F& pixel : light.pixels()) {
    if (picture.overflow == description::Overflow::hue_preserving) pixel = scaled_to_range(pixel);
    pixel = {clamped(pixel.r), clamped(pixel.g), clamped(pixel.b), clamped(pixel.a)};
  }
  return light;
}

Image<Rgba8> srgb_codes_of(const Image<Rgba32F>& image) {
  Image<Rgba8> codes(image.width(), image.height());
  const auto code = [](float intensity) { return srgb_code_from_linear(static_cast<double>(intensity)); };
  for (std::size_t i = 0; i < codes.pixels().size(); ++i) {
    const Rgba32F& from = image.pixels()[i];
    codes.pixels()[i] = {code(from.r), code(from.g), code(from.b), unorm8_from_linear(from.a)};
  }
  return codes;
}

}  // namespace tuberia
