#pragma once
// The random numbers of the tests: the same on every machine, and named by their seed.

#include <cstdint>

namespace tuberia::test {

/// splitmix64 (Steele, Lea and Flood 2014): seed 1 begins 0x910a2dec89025cc1, 0xbeeb8da1658eec67.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}

  std::uint64_t u64() noexcept { return mixed(state_ += 0x9e3779b97f4a7c15u); }

  /// A whole number in [0, n).
  std::int64_t below(std::int64_t n) noexcept {
    return static_cast<std::int64_t>(u64() % static_cast<std::uint64_t>(n));
  }

  /// A float in [low, high).
  float between(float low, float high) noexcept {
    const double unit = static_cast<double>(u64() >> 40) * 0x1p-24;
    return static_cast<float>(static_cast<double>(low) + unit * (static_cast<double>(high) - static_cast<double>(low)));
  }

  /// A number as random as its argument is not.
  static std::uint64_t mixed(std::uint64_t z) noexcept {
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }

 private:
  std::uint64_t state_;
};

}  // namespace tuberia::test
