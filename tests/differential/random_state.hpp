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

/// Topology and all state, for a target; the program's textures are still missing.
void random_state(Dice&, oracle::Draw&, const TargetDescription&);

/// Lighting at the vertices, perhaps, and normals for it.
void random_lighting(Dice&, oracle::Draw&);

/// Normals of any length: unit, none, denormal, long.
void give_normals(Dice&, oracle::Draw&);

/// The textures that the program needs, kept by the scene, and samplers and combinations to read them with.
void random_textures(Dice&, oracle::Draw&, Scene&);

/// Texture coordinates made from object positions, for some units, and matrices.
void random_texture_coordinates(Dice&, oracle::Draw&);

}  // namespace tuberia::differential
