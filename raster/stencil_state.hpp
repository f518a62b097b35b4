#pragma once
// The stencil test: a small counter a pixel (or sample) that decides, and that the decision changes.

#include <cstdint>

#include "raster/depth_state.hpp"

namespace tuberia {

/// What becomes of the stored code S, with n = 255: increment and decrement stay within 0..n, their
/// _wrap forms go round.
enum class StencilOperation : std::uint8_t { keep, zero, replace, increment, decrement, invert, increment_wrap, decrement_wrap };

/// The test passes when (reference & read_mask) stands in the relation to (stored & read_mask).
struct StencilFace {
  Compare test = Compare::always;
  std::uint8_t reference = 0, read_mask = 0xff, write_mask = 0xff;
  StencilOperation fail = StencilOperation::keep;        // the stencil test fails
  StencilOperation depth_fail = StencilOperation::keep;  // it passes, the depth test fails
  StencilOperation pass = StencilOperation::keep;        // both pass
  bool operator==(const StencilFace&) const = default;
};

/// Points and lines have a front only.
struct StencilState {
  bool enabled = false;  // needs a target with a stencil buffer
  StencilFace front{}, back{};
  bool operator==(const StencilState&) const = default;
};

}  // namespace tuberia
