#include "examples/tuberia/heat.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "examples/tuberia/render_model.hpp"

namespace tuberia::cli {
namespace {

constexpr Rgba8 kNothing{14, 30, 26, 255};

}  // namespace

Rgba8 heat_colour(float t) noexcept {
  constexpr std::array<std::array<float, 3>, 6> kStops{{{44, 52, 132}, {100, 40, 150}, {178, 44, 112}, {230, 88, 56}, {250, 170, 50}, {255, 250, 190}}};
  const float at = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(kStops.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const float share = at - static_cast<float>(first);
  const auto mixed = [&](std::size_t c) {
    return static_cast<std::uint8_t>(std::lround(kStops[first][c] + (kStops[first + 1][c] - kStops[first][c]) * share));
  };
  return {mixed(0), mixed(1), mixed(2), 255};
}

ValueRange range_of(const Image<float>& values, float nothing) {
  ValueRange range;
  double sum = 0;
  for (const float value : values.pixels()) {
    if (!(value > nothing)) continue;
    range.low = range.count == 0 ? value : std::min(range.low, value);
    range.high = range.count == 0 ? value : std::max(range.high, value);
    sum += static_cast<double>(value);
    ++range.count;
  }
  if (range.count > 0) range.mean = static_cast<float>(sum / static_cast<double>(range.count));
  return range;
}

Image<Rgba8> heat_image(const Image<float>& values, const ValueRange& range, bool logarithmic, float nothing) {
  const auto scaled = [&](float value) { return logarithmic ? std::log2(std::max(value, 1e-9f)) : value; };
  const float low = scaled(range.low), extent = scaled(range.high) - low;
  Image<Rgba8> image(values.width(), values.height(), kNothing);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (const float value = values.at(x, y); value > nothing) image.at(x, y) = heat_colour(extent > 0 ? (scaled(value) - low) / extent : 1);
  return image;
}

std::string legend_of(const ValueRange& range, const std::string& unit, bool logarithmic) {
  if (range.count == 0) return "nothing was drawn";
  char text[160];
  std::snprintf(text, sizeof text, "%.4g (dark) to %.4g (light) %s%s, %.4g in the mean of ", static_cast<double>(range.low),
                static_cast<double>(range.high), unit.c_str(), logarithmic ? ", logarithmic" : "", static_cast<double>(range.mean));
  return text + with_commas(range.count) + " pixels; the rest is dark green";
}

}  // namespace tuberia::cli
