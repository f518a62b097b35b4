#pragma once
// A rectangle of pixels in memory, row 0 at the top.

#include <cstdint>
#include <span>
#include <vector>

#include "base/assertion.hpp"

namespace tuberia {

/// Four 8-bit codes, 0..255 each; the owner of the image knows whether they are sRGB or linear.
struct Rgba8 {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Rgba8&) const = default;
};

/// Four linear intensities, usually in [0, 1].
struct Rgba32F {
  float r = 0, g = 0, b = 0, a = 1;
  bool operator==(const Rgba32F&) const = default;
};

template <class Pixel>
class Image {
 public:
  Image() = default;
  Image(int width_pixels, int height_pixels, const Pixel& fill = {})
      : width_(width_pixels), height_(height_pixels),
        pixels_(static_cast<std::size_t>(width_pixels) * static_cast<std::size_t>(height_pixels), fill) {}

  int width() const noexcept { return width_; }
  int height() const noexcept { return height_; }
  bool empty() const noexcept { return pixels_.empty(); }

  Pixel& at(int x, int y) noexcept { return pixels_[index(x, y)]; }
  const Pixel& at(int x, int y) const noexcept { return pixels_[index(x, y)]; }

  /// All pixels, row by row. Not of a temporary: a loop over them would outlive it.
  std::span<Pixel> pixels() & noexcept { return pixels_; }
  std::span<const Pixel> pixels() const& noexcept { return pixels_; }
  void pixels() const&& = delete;
  std::span<Pixel> row(int y) & noexcept { return pixels().subspan(index(0, y), static_cast<std::size_t>(width_)); }
  std::span<const Pixel> row(int y) const& noexcept {
    return pixels().subspan(index(0, y), static_cast<std::size_t>(width_));
  }
  void row(int y) const&& = delete;

  bool operator==(const Image&) const = default;

 private:
  std::size_t index(int x, int y) const noexcept {
    TUBERIA_ASSERT(x >= 0 && x < width_ && y >= 0 && y < height_, "pixel outside the image");
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_ = 0, height_ = 0;
  std::vector<Pixel> pixels_;
};

}  // namespace tuberia
