#include "raster/half_float.hpp"

#include <bit>
#include <cmath>

namespace tuberia {

std::uint16_t half_from_float(float value) noexcept {
  if (std::isnan(value)) return 0x7e00;
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = bits >> 31, magnitude = bits & 0x7fffffffu;
  if (magnitude >= 0x47800000u) return static_cast<std::uint16_t>(sign << 15 | 0x7c00u);  // 65536 and more
  // Below the normal halves the step is 2^-24, as that of floats from 1/2 on: their sum rounds alike.
  if (magnitude < 0x38800000u) {
    const float shifted = std::bit_cast<float>(magnitude) + 0.5f;
    return static_cast<std::uint16_t>(sign << 15 | (std::bit_cast<std::uint32_t>(shifted) - 0x3f000000u));
  }
  // Half a step less one unit, and that unit where the last bit that stays is odd. A carry goes on
  // into the exponent, up to infinity.
  const std::uint32_t odd = magnitude >> 13 & 1u;
  const std::uint32_t rounded = magnitude - (112u << 23) + 0xfffu + odd;
  return static_cast<std::uint16_t>(sign << 15 | rounded >> 13);
}

float float_from_half(std::uint16_t half) noexcept {
  const std::uint32_t sign = (half & 0x8000u) << 16, magnitude = half & 0x7fffu;
  if (magnitude < 0x400u) {
    const float small = static_cast<float>(magnitude) * 0x1p-24f;
    return std::bit_cast<float>(sign | std::bit_cast<std::uint32_t>(small));
  }
  const std::uint32_t shift = magnitude < 0x7c00u ? 112u << 23 : 224u << 23;
  return std::bit_cast<float>(sign | ((magnitude << 13) + shift));
}

}  // namespace tuberia
