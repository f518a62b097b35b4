#include "raster/srgb_encoding.hpp"

#include <bit>

#include "math/colour.hpp"

namespace tuberia {
namespace {

SrgbEncoding make_encoding() {
  SrgbEncoding encoding{};
  encoding.threshold = srgb_code_thresholds();
  for (int i = 0; i < SrgbEncoding::kBuckets; ++i) {
    const std::int32_t bits = (SrgbEncoding::kFirstBucket + i) << SrgbEncoding::kShift;
    encoding.code_of_bucket[static_cast<std::size_t>(i)] =
        srgb_code_from_linear(static_cast<double>(std::bit_cast<float>(bits)));
  }
  return encoding;
}

}  // namespace

const SrgbEncoding& srgb_encoding() {
  static const SrgbEncoding encoding = make_encoding();
  return encoding;
}

}  // namespace tuberia
