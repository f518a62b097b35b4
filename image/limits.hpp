#pragma once
// How large an image may be, so that a few corrupt bytes cannot claim all of the memory.

#include <cstdint>
#include <string>

namespace tuberia {

inline constexpr int kLargestSidePixels = 32768;
inline constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;  // 1 GiB as Rgba8

constexpr bool reasonable_size(int width, int height) noexcept {
  return width > 0 && height > 0 && width <= kLargestSidePixels && height <= kLargestSidePixels &&
         std::int64_t{width} * height <= kMostPixels;
}

/// "640x480"
inline std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace tuberia
