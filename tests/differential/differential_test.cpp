// The pipeline against the scalar oracle, on random states.

#include <catch2/catch.hpp>

#include "tests/differential/comparison.hpp"
#include "tests/differential/random_state.hpp"
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

/// One draw of so many vertices that the pipeline cuts it into several chunks.
Scene scene_of_many(std::uint64_t seed, oracle::Topology topology, int threads) {
  Dice dice(seed);
  Scene scene;
  scene.seed = seed;
  scene.target = {.width = 24, .height = 20};
  scene.threads = threads;
  scene.instruction_set = best_instruction_set();
  oracle::Draw draw;
  draw.topology = topology;
  draw.depth_test = oracle::Compare::less_equal;
  draw.blend.mode = oracle::BlendMode::source_over;
  draw.stipple = oracle::Stipple{0x6c35, 3};
  for (int i = 0; i < 5000; ++i) {
    oracle::InputVertex v;
    v.position = {dice.between(-1.3f, 1.3f), dice.between(-1.3f, 1.3f), dice.between(-1.1f, 1), dice.between(0.5f, 2)};
    v.colour = {dice.between(0, 1), dice.between(0, 1), dice.between(0, 1), dice.between(0, 0.5f)};
    draw.vertices.push_back(v);
  }
  // In front of everything, so that nothing hides the line that closes a loop.
  draw.vertices.front().position = {-0.9f, -0.8f, -1, 1};
  draw.vertices.back().position = {0.9f, 0.7f, -1, 1};
  scene.draws.push_back(draw);
  return scene;
}

TEST_CASE("differential: draws of many chunks agree, on any number of threads", "[differential][exact]") {
  Machines machines;
  const auto topology = GENERATE(oracle::Topology::triangles, oracle::Topology::triangle_strip, oracle::Topology::line_strip,
                                 oracle::Topology::line_loop, oracle::Topology::points);
  const int threads = GENERATE(1, 3);
  std::string first;
  const Tally tally = compare(scene_of_many(81, topology, threads), machines, first);
  INFO("seed 81, topology " << static_cast<int>(topology) << ", " << threads << " threads: " << first);
  CHECK(tally.disagreements() == 0);
  CHECK(tally.fragments > 1000);
}

}  // namespace
}  // namespace tuberia::differential
