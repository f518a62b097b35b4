#include "image/exposure.hpp"

#include <algorithm>
#include <cmath>

namespace tuberia {

void expose(Image<Rgba32F>& image, float factor) {
  TUBERIA_ASSERT(factor >= 0, "an exposure is not negative");
  for (Rgba32F& pixel : image.pixels()) pixel = {pixel.r * factor, pixel.g * factor, pixel.b * factor, pixel.a};
}

float largest_channel(const Image<Rgba32F>& image) {
  float largest = 0;
  for (const Rgba32F& pixel : image.pixels())
    for (const float channel : {pixel.r, pixel.g, pixel.b})
      if (std::isfinite(channel)) largest = std::max(largest, channel);
  return largest;
}

float scale_to_range(Image<Rgba32F>& image) {
  const float divisor = std::max(largest_channel(image), 1.0f);
  if (divisor > 1)
    for (Rgba32F& pixel : image.pixels()) pixel = {pixel.r / divisor, pixel.g / divisor, pixel.b / divisor, pixel.a};
  return divisor;
}

}  // namespace tuberia
