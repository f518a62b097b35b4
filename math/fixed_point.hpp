#pragma once
// 24.8 fixed-point screen coordinates: after the snap, every question of coverage is an integer one.

#include <cmath>
#include <cstdint>

namespace tuberia {

inline constexpr int kSubpixelBits = 8;                         // one pixel is 256 units
inline constexpr std::int32_t kSubpixelUnits = 1 << kSubpixelBits;
inline constexpr std::int32_t kPixelCentre = kSubpixelUnits / 2;  // of pixel 0, in units
inline constexpr int kGuardBandPixels = 32768;                  // vertices lie within +-this
inline constexpr std::int32_t kGuardBandUnits = kGuardBandPixels * kSubpixelUnits;

// Differences of coordinates need 25 bits, an edge function 2 * 2^24 * 2^24 = 2^49: exact in a
// double's 53 bits and in 64-bit integers.
static_assert(kGuardBandUnits == 1 << 23);

/// Screen coordinate in pixels -> 24.8 units, rounded once to the nearest multiple of 2^-subpixel_bits
/// pixels (0..8 bits), ties to even; beyond the guard band the nearest value inside; not-a-number
/// gives 0.                                                                        [rules R1]
inline std::int32_t snap(double pixels, int subpixel_bits = kSubpixelBits) noexcept {
  if (!(pixels == pixels)) return 0;
  const double steps = 1 << subpixel_bits;
  const double units = std::nearbyint(pixels * steps) * (kSubpixelUnits / steps);
  if (units >= kGuardBandUnits) return kGuardBandUnits;
  if (units <= -kGuardBandUnits) return -kGuardBandUnits;
  return static_cast<std::int32_t>(units);
}

}  // namespace tuberia
