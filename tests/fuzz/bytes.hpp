#pragma once
// Bytes as numbers, one after the other; zeros when there are no more.

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "tests/fuzz/targets.hpp"

namespace tuberia::fuzz {

class Bytes {
 public:
  explicit Bytes(Input input) noexcept : left_(input) {}

  bool are_left() const noexcept { return !left_.empty(); }
  std::uint8_t byte() noexcept {
    if (left_.empty()) return 0;
    const std::uint8_t first = left_.front();
    left_ = left_.subspan(1);
    return first;
  }
  std::uint32_t word() noexcept {
    std::uint32_t bits = 0;
    for (int shift = 0; shift < 32; shift += 8) bits |= static_cast<std::uint32_t>(byte()) << shift;
    return bits;
  }
  /// 0..n-1, n up to 256.
  int below(int n) noexcept { return byte() % n; }
  /// low..high.
  int between(int low, int high) noexcept { return low + static_cast<int>((byte() | byte() << 8) % (high - low + 1)); }
  bool flag() noexcept { return (byte() & 1) != 0; }
  template <class Enumeration>
  Enumeration one_of(int n) noexcept { return static_cast<Enumeration>(below(n)); }

  /// Any float at all; mostly ones that meet: multiples of 1/64 within +-8, and values that hurt.
  float number() noexcept {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    constexpr std::array<float, 16> kSpecial{0.0f, -0.0f, 1.0f, -1.0f, 0.5f, 1e-45f, 1.17549435e-38f, 3.4028235e38f, -3.4028235e38f, kInfinity, -kInfinity,
                                             std::numeric_limits<float>::quiet_NaN(), 1e-30f, 1e30f, 32768, 2.0f};
    const int kind = below(8);
    if (kind < 4) return static_cast<float>(between(-512, 512)) / 64;
    if (kind < 6) return kSpecial[static_cast<std::size_t>(below(16))];
    return std::bit_cast<float>(word());
  }
  /// Within [0, 1].
  float share() noexcept { return static_cast<float>(byte()) / 255; }

 private:
  Input left_;
};

}  // namespace tuberia::fuzz
