#pragma once
// The depth test: what is compared, how, and what is kept.

#include <cstdint>

namespace tuberia {

/// Passes when the new depth stands in this relation to the stored one.
enum class Compare : std::uint8_t { never, less, equal, less_equal, greater, not_equal, greater_equal, always };

/// What the depth buffer stores: 16- or 24-bit codes of [0, 1], or 32-bit floats.
enum class DepthFormat : std::uint8_t { d16, d24, d32f };

struct DepthState {
  Compare test = Compare::less;
  bool write = true;
  bool operator==(const DepthState&) const = default;
};

/// No test and no write: nearness does not matter.
inline constexpr DepthState kDepthOff{.test = Compare::always, .write = false};

}  // namespace tuberia
