// The pipeline against the scalar oracle, on random states.

#include <catch2/catch.hpp>

#include "tests/differential/comparison.hpp"
#include "tests/differential/shrinking.hpp"

namespace tuberia::differential {
namespace {

constexpr std::uint64_t kFirstSeed = 1;
constexpr int kStates = 2000;

TEST_CASE("differential: pipeline and oracle agree on random states", "[differential][exact]") {
  Machines machines;
  Tally total;
  for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + kStates; ++seed) {
    const Scene scene = random_scene(seed);
    std::string first;
    const Tally tally = compare(scene, machines, first);
    total += tally;
    if (tally.disagreements() > 0) {
      INFO("seed " << seed << "\n" << explained(scene, machines));
      CHECK(tally.disagreements() == 0);
      return;
    }
  }
  INFO(total.tied_channels << " of " << total.drawn_channels << " channels at ties, " << total.uncertain_samples << " of "
                           << total.samples << " samples uncertain");
  CHECK(total.fragments > 100'000);
  // Were the bounds wide, they would hide mistakes.
  CHECK(total.tied_channels * 50 < total.drawn_channels);
  CHECK(total.uncertain_samples * 200 < total.samples);
}

}  // namespace
}  // namespace tuberia::differential
