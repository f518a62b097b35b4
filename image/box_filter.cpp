#include "image/box_filter.hpp"

#include <array>

namespace tuberia {
namespace {

Rgba32F mean_of_square(const Image<Rgba32F>& image, int left, int top, int size) {
  std::array<double, 4> sum{};
  for (int y = top; y < top + size; ++y)
    for (int x = left; x < left + size; ++x) {
      const Rgba32F& p = image.at(x, y);
      sum[0] += static_cast<double>(p.r);
      sum[1] += static_cast<double>(p.g);
      sum[2] += static_cast<double>(p.b);
      sum[3] += static_cast<double>(p.a);
    }
  const double pixels = static_cast<double>(size) * size;
  return {static_cast<float>(sum[0] / pixels), static_cast<float>(sum[1] / pixels), static_cast<float>(sum[2] / pixels),
          static_cast<float>(sum[3] / pixels)};
}

}  // namespace

Image<Rgba32F> box_filtered(const Image<Rgba32F>& image, int factor) {
  TUBERIA_ASSERT(factor >= 1 && image.width() % factor == 0 && image.height() % factor == 0, "squares must tile the image");
  Image<Rgba32F> filtered(image.width() / factor, image.height() / factor);
  for (int y = 0; y < filtered.height(); ++y)
    for (int x = 0; x < filtered.width(); ++x) filtered.at(x, y) = mean_of_square(image, x * factor, y * factor, factor);
  return filtered;
}

}  // namespace tuberia
