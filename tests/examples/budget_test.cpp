// tuberia render with a budget: what it says, what it draws, and what it refuses.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "tests/examples/run_program.hpp"

namespace tuberia {
namespace {

void write_square(const std::filesystem::path& path) {
  std::ofstream(path) << "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\n";
}

}  // namespace

TEST_CASE("tuberia: a budget that cannot be read or that nothing could keep is refused by name", "[examples][adviser]") {
  const TemporaryFolder folder;
  write_square(folder / "square.obj");
  struct Refused {
    const char *arguments, *culprit;
  };
  for (const Refused& each : {Refused{"--error-budget little", "'little'"}, {"--error-budget 1.5", "'1.5'"}, {"--error-budget 0.5/100", "'0.5/100'"},
                              {"--error-budget -0.1", "-0.1"}, {"--error-budget nan", "'nan'"}, {"--time-budget 16", "'16'"},
                              {"--time-budget 0ms", "'0ms'"}, {"--time-budget 16min", "'16min'"},
                              {"--explain", "--explain"}, {"--error-budget 0.1 --view depth", "--view"},
                              {"--error-budget 0.1 --precision fast", "--precision"}, {"--time-budget 1s --filter nearest", "--filter"}}) {
    const test::Outcome outcome = test::run_program(std::string("render square.obj -o out.png ") + each.arguments, folder);
    INFO(each.arguments << " says: " << outcome.output);
    CHECK(outcome.status > 0);
    CHECK(outcome.output.find(each.culprit) != std::string::npos);
    CHECK(!std::filesystem::exists(folder / "out.png"));
  }
}

TEST_CASE("tuberia: with a budget it says what it chose, predicted and measured, and draws that", "[examples][adviser]") {
  const TemporaryFolder folder;
  write_square(folder / "square.obj");
  const test::Outcome none = test::run_program("render square.obj -o none.png --size 128x96 --error-budget 0 --explain", folder);
  INFO(none.output);
  CHECK(none.status == 0);
  for (const char* words : {"budget: RMSE 0.00/255", "predicted:", "measured:", "why each switch stands so", "nothing is textured", "tried on this picture"})
    CHECK(none.output.find(words) != std::string::npos);

  // Nothing may differ, so nothing does.
  REQUIRE(test::run_program("render square.obj -o plain.png --size 128x96", folder).status == 0);
  CHECK(test::run_program("compare none.png plain.png", folder).status == 0);

  const test::Outcome hopeless = test::run_program("render square.obj -o out.png --size 128x96 --time-budget 0.000001ms", folder);
  CHECK(hopeless.status == 0);
  CHECK(hopeless.output.find("NO setting keeps this budget") != std::string::npos);
}

}  // namespace tuberia
