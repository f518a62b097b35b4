#pragma once
// Light of which only bounds are known, and a share of light of which only bounds are known.

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace tuberia::witness {

/// 0..1: how much of a light arrives.
struct ShareRange {
  double low = 1, high = 1;
};

/// Linear RGB, channel by channel.
struct LightRange {
  glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

  static LightRange of(const glm::dvec3& light) { return {light, light}; }
  bool empty() const { return !(low.r <= high.r); }
  void include(const LightRange& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  void add(const glm::dvec3& light) {
    low += light;
    high += light;
  }
  /// light: 0 or more.
  void add(const ShareRange& share, const glm::dvec3& light) {
    low += share.low * light;
    high += share.high * light;
  }
};

}  // namespace tuberia::witness
