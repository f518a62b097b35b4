#include <catch2/catch.hpp>

#include "bench/guard/baseline.hpp"

namespace tuberia::bench {
namespace {

Verdict verdict_on(std::int64_t recorded, std::int64_t counted) {
  return compare({{"fill", recorded}}, {{"fill", counted}}).at(0).verdict;
}

std::string refusal_of_baseline(std::string_view text) {
  const auto baseline = parse_baseline(text, "bench/baseline.txt");
  REQUIRE_FALSE(baseline.ok());
  return baseline.error().message;
}

}  // namespace

TEST_CASE("guard: three percent more pass, more than that fails", "[bench]") {
  CHECK(verdict_on(100000, 100000) == Verdict::holds);
  CHECK(verdict_on(100000, 102999) == Verdict::holds);
  CHECK(verdict_on(100000, 103001) == Verdict::worse);
  CHECK(verdict_on(100000, 97001) == Verdict::holds);
  CHECK(verdict_on(100000, 96999) == Verdict::better);
}

TEST_CASE("guard: one workload that is worse fails all, and the table names it", "[bench]") {
  const std::vector<InstructionCount> recorded{{"fill", 100}, {"blend", 100}};
  CHECK(passes(compare(recorded, {{"fill", 101}, {"blend", 50}})));
  const auto comparisons = compare(recorded, {{"fill", 101}, {"blend", 110}});
  CHECK_FALSE(passes(comparisons));
  const std::string table = table_of(comparisons);
  const std::size_t blend = table.find("blend");
  REQUIRE(blend != std::string::npos);
  CHECK(table.find("+10.00 %  TOO MANY", blend) != std::string::npos);
  CHECK(table.rfind("TOO MANY", blend) == std::string::npos);
}

TEST_CASE("guard: a workload on one side only fails", "[bench]") {
  CHECK_FALSE(passes(compare({{"fill", 100}}, {{"fill", 100}, {"new", 5}})));
  CHECK_FALSE(passes(compare({{"fill", 100}, {"old", 5}}, {{"fill", 100}})));
}

TEST_CASE("guard: a baseline that was written can be read", "[bench]") {
  const Baseline baseline{.compiler = "g++ 12.2.0", .counts = {{"fill_gouraud", 123456789}, {"tiny", 1}}};
  const auto read = parse_baseline(text_of(baseline), "baseline.txt");
  REQUIRE(read.ok());
  CHECK(read->compiler == baseline.compiler);
  CHECK(read->counts == baseline.counts);
}

TEST_CASE("guard: an unreadable baseline names the file and the line", "[bench]") {
  CHECK(refusal_of_baseline("# counts\ncompiler g++\nfill many\n") ==
        "bench/baseline.txt:3: 'many' is not a number of instructions");
  CHECK(refusal_of_baseline("compiler g++\nfill 12 apples\n") ==
        "bench/baseline.txt:2: '12 apples' is not a number of instructions");
  CHECK(refusal_of_baseline("compiler g++\nfill -5\n") == "bench/baseline.txt:2: '-5' is not a number of instructions");
  CHECK(refusal_of_baseline("compiler g++\n\nfill\n") ==
        "bench/baseline.txt:3: 'fill' stands alone; a workload and its instructions are expected");
  CHECK(refusal_of_baseline("compiler g++\nfill 1\nfill 2\n") == "bench/baseline.txt:3: a second count of fill");
  CHECK(refusal_of_baseline("compiler g++\ncompiler clang\n") == "bench/baseline.txt:2: a second compiler");
  CHECK(refusal_of_baseline("fill 5\n") == "bench/baseline.txt: no line says which compiler");
  CHECK(refusal_of_baseline("compiler g++\n") == "bench/baseline.txt: no workload is recorded");
}

}  // namespace tuberia::bench
