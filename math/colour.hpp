#pragma once
// Codes of an 8-bit image and the linear light they stand for.

#include <array>
#include <cstdint>

namespace tuberia {

/// Linear intensity of an sRGB signal, IEC 61966-2-1. Both in [0, 1]; the signal is not clamped.
double linear_from_srgb(double signal) noexcept;

/// sRGB signal of a linear intensity, IEC 61966-2-1. Both in [0, 1]; the intensity is not clamped.
double srgb_from_linear(double intensity) noexcept;

/// Entry c is the linear intensity of sRGB code c, rounded once to float: [0] is 0, [255] is 1.
const std::array<float, 256>& linear_from_srgb_codes();

/// The sRGB code nearest to a linear intensity, by signal. Clamps to 0..1; NaN gives 0.
std::uint8_t srgb_code_from_linear(double intensity) noexcept;

/// Entry c is the smallest float intensity whose nearest sRGB code is at least c; [0] is minus
/// infinity and [256] plus infinity. The nearest code of a finite float x is therefore the one c
/// with entry[c] <= x < entry[c + 1].
const std::array<float, 257>& srgb_code_thresholds();

/// The code of a linear 8-bit target: floor(255 x + 0.5) of x clamped to 0..1, NaN gives 0
/// (rules B1). The product is rounded to float, as in a wide kernel; the rest is exact.
std::uint8_t unorm8_from_linear(float intensity) noexcept;

}  // namespace tuberia
