#pragma once
// Floats as the keys of tables.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace tuberia {

/// The bits of a float, 0 for -0.
inline std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value + 0.0f); }

template <std::size_t kCount>
using Bits = std::array<std::uint32_t, kCount>;

struct HashBits {
  template <std::size_t kCount>
  std::size_t operator()(const Bits<kCount>& words) const noexcept {
    std::uint64_t hash = 0x9e3779b97f4a7c15u;
    for (const std::uint32_t word : words) {
      hash = (hash ^ word) * 0xff51afd7ed558ccdu;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

}  // namespace tuberia
