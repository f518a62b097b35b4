#pragma once
// The dice, and a random state of everything after the vertices.

#include <initializer_list>
#include <vector>

#include "reference/oracle/state.hpp"
#include "tests/differential/scene.hpp"
#include "tests/support/random.hpp"

namespace tuberia::differential {

class Dice : public test::Random {
 public:
  using Random::Random;
  bool one_in(std::int64_t n) noexcept { return below(n) == 0; }
  double unit() noexcept { return static_cast<double>(u64() >> 11) * 0x1p-53; }
  /// A number 0..n-1, number i with the i-th weight.
  int weighted(const std::vector<int>& weights) {
    std::int64_t sum = 0;
    for (const int weight : weights) sum += weight;
    std::int64_t left = below(sum);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (left < weights[i]) return static_cast<int>(i);
      left -= weights[i];
    }
    return 0;
  }
};

/// What the generator may use.
struct Enabled {
  bool points_and_lines = true, polygon_modes = true, user_planes = true, polygon_offset = true, two_sided = true;
  bool fog = true, alpha_test = true, stencil = true, blend_function = true, logic = true, mask = true;
  bool half_floats = true, multisampling = true, clip_and_screen_positions = true;
};
inline constexpr Enabled kEnabled{};

/// Topology and all state, for a target; the program's texture is still missing.
void random_state(Dice&, oracle::Draw&, const TargetDescription&);

}  // namespace tuberia::differential
