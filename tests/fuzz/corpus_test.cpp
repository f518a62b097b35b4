// Every input that the fuzzers kept, in every build: those that reached something new, and those that
// once found a mistake.

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/fuzz/targets.hpp"
#include "tests/support/random.hpp"

namespace tuberia::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> corpus_of(const std::string& target) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator("tests/fuzz/corpus/" + target)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

void replay(const std::string& target, std::string (*attempt)(Input)) {
  const std::vector<fs::path> files = corpus_of(target);
  CHECK(!files.empty());
  for (const fs::path& file : files) {
    std::ifstream stream(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
    INFO(file);
    CHECK(attempt({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}) == "");
  }
}

TEST_CASE("fuzz: the raster corpus does no harm", "[fuzz]") { replay("raster", try_raster); }
TEST_CASE("fuzz: the corpus of files does no harm", "[fuzz]") { replay("files", try_files); }
TEST_CASE("fuzz: the corpus of options does no harm", "[fuzz]") { replay("options", try_options); }

TEST_CASE("fuzz: random bytes as draws do no harm", "[fuzz]") {
  test::Random random(17);
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(100 + random.below(800)));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.u64());
    INFO("seed 17, input " << i);
    CHECK(try_raster(bytes) == "");
  }
}

}  // namespace
}  // namespace tuberia::fuzz
