#pragma once
// A front buffer that is shown and a back buffer that is drawn.                                 [C 4.7]

#include <array>
#include <cstddef>
#include <utility>

#include "base/result.hpp"
#include "raster/render_target.hpp"

namespace tuberia {

/// Two targets of one description. What is shown is always a whole frame: drawing changes the back one
/// alone, and swap() exchanges them at once, without a copy.
class DoubleBuffer {
 public:
  /// Both begin as RenderTarget::create leaves them. Its errors.
  static Result<DoubleBuffer> create(const RenderTargetDescription& description) {
    auto first = RenderTarget::create(description);
    if (!first) return first.error();
    auto second = RenderTarget::create(description);
    if (!second) return second.error();
    return DoubleBuffer(*std::move(first), *std::move(second));
  }

  const RenderTarget& front() const noexcept { return buffers_[1 - back_]; }
  RenderTarget& back() noexcept { return buffers_[back_]; }

  /// The frame that was drawn is shown. The new back buffer holds the frame that was shown before: clear it.
  void swap() noexcept { back_ = 1 - back_; }

 private:
  DoubleBuffer(RenderTarget&& first, RenderTarget&& second) : buffers_{std::move(first), std::move(second)} {}

  std::array<RenderTarget, 2> buffers_;
  std::size_t back_ = 0;
};

}  // namespace tuberia
