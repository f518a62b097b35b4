#include "reference/oracle/target.hpp"

#include <bit>
#include <cmath>

namespace tuberia::oracle {
namespace {

// IEC 61966-2-1, both ways.
double intensity_of_signal(double signal) {
  return signal <= 0.04045 ? signal / 12.92 : std::pow((signal + 0.055) / 1.055, 2.4);
}
double signal_of_intensity(double intensity) {
  return intensity <= 0.0031308 ? 12.92 * intensity : 1.055 * std::pow(intensity, 1 / 2.4) - 0.055;
}

/// floor(255 x + 1/2), where the product is a float.
double unorm8_code(double x) {
  const float product = 255.0f * static_cast<float>(std::clamp(x, 0.0, 1.0));
  return std::floor(static_cast<double>(product) + 0.5);
}

double srgb8_code(double x) { return std::floor(255 * signal_of_intensity(std::clamp(x, 0.0, 1.0)) + 0.5); }

/// The nearest number of 11 significant bits, ties to even; from 65520 on infinite.
double half(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  const double step = std::ldexp(1.0, std::max(std::ilogb(x), -14) - 10);
  const double nearest = std::nearbyint(x / step) * step;
  if (std::abs(nearest) < 65520) return nearest;
  return std::copysign(std::numeric_limits<double>::infinity(), x);
}

}  // namespace

Target::Target(int target_width, int target_height, int samples_per_pixel, ColourFormat colour, DepthFormat depth)
    : width(target_width), height(target_height), samples(samples_per_pixel), colour_format(colour), depth_format(depth),
      contents(static_cast<std::size_t>(target_width) * static_cast<std::size_t>(target_height) *
               static_cast<std::size_t>(samples_per_pixel)) {}

void Target::clear(const glm::vec4& colour, float depth, std::uint8_t stencil) {
  Sample cleared;
  for (int i = 0; i < 4; ++i) cleared.colour[static_cast<std::size_t>(i)] = stored(static_cast<double>(colour[i]), i, colour_format);
  cleared.depth = depth_code(depth, depth_format);
  cleared.stencil = stencil;
  contents.assign(contents.size(), cleared);
}

void Target::clear(const Clear& part) {
  const Rectangle rectangle = part.scissor.value_or(Rectangle{0, 0, width, height});
  for (int y = std::max(0, rectangle.top); y < std::min(height, rectangle.bottom); ++y)
    for (int x = std::max(0, rectangle.left); x < std::min(width, rectangle.right); ++x)
      for (int s = 0; s < samples; ++s) {
        Sample& sample = at(x, y, s);
        for (int i = 0; i < 4; ++i)
          if (part.colour && part.mask[static_cast<std::size_t>(i)])
            sample.colour[static_cast<std::size_t>(i)] = stored(static_cast<double>((*part.colour)[i]), i, colour_format);
        if (part.depth) sample.depth = depth_code(*part.depth, depth_format);
        const int bits = part.stencil_write_mask;
        if (part.stencil) sample.stencil = static_cast<std::uint8_t>((sample.stencil & ~bits) | (*part.stencil & bits));
      }
}

Sample Target::resolved(int x, int y) {
  Sample pixel = at(x, y, 0);
  if (samples == 1) return pixel;
  const double count = samples;
  for (int i = 0; i < 4; ++i) {
    const bool mean_of_codes = colour_format == ColourFormat::rgba8 || (is_8_bit(colour_format) && i == 3);
    double low = 0, high = 0;     // sums of whole codes are exact
    Interval sum = 0.0;           // sums of decoded intensities are bounded
    float least = 0, most = 0;    // sums of floats are rounded one by one
    for (int s = 0; s < samples; ++s) {
      const Interval& one = at(x, y, s).colour[static_cast<std::size_t>(i)];
      low += one.low;
      high += one.high;
      least += static_cast<float>(one.low);
      most += static_cast<float>(one.high);
      sum = sum + linear(one, i, colour_format);
      pixel.is_uncertain = pixel.is_uncertain || at(x, y, s).is_uncertain;
    }
    Interval& mean = pixel.colour[static_cast<std::size_t>(i)];
    const float share = static_cast<float>(1 / count);
    const Interval mean_of_floats = std::isfinite(least) && std::isfinite(most)
                                        ? Interval{static_cast<double>(least * share), static_cast<double>(most * share)}
                                        : unknown();
    if (!is_8_bit(colour_format)) mean = stored(mean_of_floats, i, colour_format);
    else if (mean_of_codes) mean = {std::floor(low / count + 0.5), std::floor(high / count + 0.5)};
    else mean = stored(sum * Interval(1 / count), i, colour_format);
  }
  return pixel;
}

SampleOffset sample_offset(int samples, int sample) {
  // Direct3D's standard patterns, 1/16 pixel from the centre.
  static constexpr int kTwo[2][2] = {{4, 4}, {-4, -4}};
  static constexpr int kFour[4][2] = {{-2, -6}, {6, -2}, {-6, 2}, {2, 6}};
  static constexpr int kEight[8][2] = {{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}};
  static constexpr int kSixteen[16][2] = {{1, 1}, {-1, -3}, {-3, 2}, {4, -1}, {-5, -2}, {2, 5}, {5, 3}, {3, -5},
                                          {-2, 6}, {0, -7}, {-4, -6}, {-6, 4}, {-8, 0}, {7, -4}, {6, 7}, {-7, -8}};
  const int* position = nullptr;
  switch (samples) {
    case 2: position = kTwo[sample]; break;
    case 4: position = kFour[sample]; break;
    case 8: position = kEight[sample]; break;
    case 16: position = kSixteen[sample]; break;
    default: return {0, 0};
  }
  return {16 * position[0], 16 * position[1]};
}

std::int32_t depth_code(float depth, DepthFormat format) {
  const double d = std::clamp(static_cast<double>(depth), 0.0, 1.0);
  if (format == DepthFormat::d32f) return std::bit_cast<std::int32_t>(static_cast<float>(d) + 0.0f);
  // The product is exact in double; so is the rounding, in two steps.
  const double scaled = d * (format == DepthFormat::d16 ? 65535.0 : 16777215.0);
  const double below = std::floor(scaled);
  return static_cast<std::int32_t>(below) + (scaled - below >= 0.5 ? 1 : 0);
}

Interval stored(Interval x, int channel, ColourFormat format) {
  if (format == ColourFormat::rgba32f) return x;
  if (format == ColourFormat::rgba16f) return {half(x.low), half(x.high)};
  if (format == ColourFormat::srgb8 && channel < 3) return {srgb8_code(x.low), srgb8_code(x.high)};
  return {unorm8_code(x.low), unorm8_code(x.high)};
}

Interval linear(Interval code, int channel, ColourFormat format) {
  if (!is_8_bit(format)) return code;
  const auto one = [&](double c) {
    return format == ColourFormat::srgb8 && channel < 3 ? intensity_of_signal(c / 255) : c / 255;
  };
  const Interval bounds{one(code.low), one(code.high)};
  // Black and white are exact in every way to decode them.
  if (bounds == Interval(0.0) || bounds == Interval(1.0)) return bounds;
  return clamped(widened(bounds), 0, 1);
}

}  // namespace tuberia::oracle
