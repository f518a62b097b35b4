#pragma once
// Tables that turn linear intensities into correctly rounded sRGB codes with two look-ups.

#include <array>
#include <cstdint>

namespace tuberia {

/// A float's exponent and the first 7 bits of its mantissa name a bucket; a bucket is so narrow
/// that the nearest code changes at most once inside it.
struct SrgbEncoding {
  static constexpr int kShift = 16;                       // bits of a float that a bucket ignores
  static constexpr float kSmallest = 0x1p-13f;            // everything below has code 0
  static constexpr std::int32_t kFirstBucket = 0x39000000 >> kShift;  // of kSmallest
  static constexpr int kBuckets = (0x3f800000 >> kShift) - kFirstBucket + 1;  // up to 1.0

  std::array<std::int32_t, kBuckets> code_of_bucket;  // the nearest code of its smallest number
  std::array<float, 257> threshold;                   // see srgb_code_thresholds
};

const SrgbEncoding& srgb_encoding();

}  // namespace tuberia
