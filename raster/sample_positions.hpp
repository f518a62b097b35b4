#pragma once
// Where the samples of a pixel lie: Direct3D's standard patterns, one for each sample count.  [rules 4]

#include <array>
#include <cstdint>
#include <span>

namespace tuberia {

inline constexpr int kMaxSamples = 16;

/// From the pixel's centre, x right and y down, in 1/16 pixel: -8..7.
struct SamplePosition {
  std::int8_t x, y;
};

inline constexpr int kUnitsPerSampleStep = 16;  // 1/16 pixel in units of 1/256

constexpr bool is_sample_count(int samples) noexcept {
  return samples == 1 || samples == 2 || samples == 4 || samples == 8 || samples == 16;
}

/// The `samples` positions of a pattern; samples: 1, 2, 4, 8 or 16.
std::span<const SamplePosition> sample_positions(int samples) noexcept;

}  // namespace tuberia
