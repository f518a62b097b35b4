#pragma once
// 16-bit floats, as targets of rgba16f store them: IEEE 754 binary16, 10 bits of mantissa.

#include <cstdint>

namespace tuberia {

/// The nearest half, ties to even; from 65520 on infinite. Every not-a-number is 0x7e00.  [rules B1]
std::uint16_t half_from_float(float value) noexcept;

/// Exact.
float float_from_half(std::uint16_t half) noexcept;

}  // namespace tuberia
