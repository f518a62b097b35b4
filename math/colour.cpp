#include "math/colour.hpp"

#include <cmath>
#include <limits>

namespace tuberia {

namespace {

// Rounding to float may go down; a threshold must not lie below the exact value.
float smallest_float_not_below(double value) {
  const float rounded = static_cast<float>(value);
  if (static_cast<double>(rounded) >= value) return rounded;
  return std::nextafter(rounded, std::numeric_limits<float>::infinity());
}

std::array<float, 256> make_linear_codes() {
  std::array<float, 256> table{};
  for (std::size_t code = 0; code < table.size(); ++code)
    table[code] = static_cast<float>(linear_from_srgb(static_cast<double>(code) / 255.0));
  return table;
}

std::array<float, 257> make_thresholds() {
  std::array<float, 257> table{};
  table.front() = -std::numeric_limits<float>::infinity();
  table.back() = std::numeric_limits<float>::infinity();
  // Code c begins half a code below its own signal.
  for (std::size_t code = 1; code < 256; ++code)
    table[code] = smallest_float_not_below(linear_from_srgb((static_cast<double>(code) - 0.5) / 255.0));
  return table;
}

}  // namespace

double linear_from_srgb(double signal) noexcept {
  return signal <= 0.04045 ? signal / 12.92 : std::pow((signal + 0.055) / 1.055, 2.4);
}

double srgb_from_linear(double intensity) noexcept {
  return intensity <= 0.0031308 ? 12.92 * intensity : 1.055 * std::pow(intensity, 1.0 / 2.4) - 0.055;
}

const std::array<float, 256>& linear_from_srgb_codes() {
  static const std::array<float, 256> table = make_linear_codes();
  return table;
}

std::uint8_t srgb_code_from_linear(double intensity) noexcept {
  // The negated comparison sends NaN to 0 as well.
  if (!(intensity > 0.0)) return 0;
  if (intensity >= 1.0) return 255;
  return static_cast<std::uint8_t>(std::floor(255.0 * srgb_from_linear(intensity) + 0.5));
}

const std::array<float, 257>& srgb_code_thresholds() {
  static const std::array<float, 257> table = make_thresholds();
  return table;
}

std::uint8_t unorm8_from_linear(float intensity) noexcept {
  if (!(intensity > 0.0f)) return 0;
  if (intensity >= 1.0f) return 255;
  return static_cast<std::uint8_t>(static_cast<double>(255.0f * intensity) + 0.5);
}

}  // namespace tuberia
