// tuberia_determinism: one digest each for colours, depths and primitives of every scene, and the
// comparison of all machines with pinned ones. Exit status 1 when they differ, 2 when misused.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

#include "tests/extremes/determinism/digests.hpp"

namespace {

using namespace tuberia;
using namespace tuberia::determinism;

constexpr int kThreads[] = {1, 2, 3, 7, 16};  // [rules, section 5]

struct Arguments {
  PipelineOptions machine{.threads = 1};
  std::string pinned_file;
};

void print_usage() {
  std::puts("usage: tuberia_determinism [--threads N] [--instruction-set NAME]\n"
            "       tuberia_determinism --check FILE\n"
            "Draws a fixed list of scenes and prints a line for each: its name and the SHA-256 of its\n"
            "colours, of its depth codes and of the primitives seen. --check does so with 1, 2, 3, 7 and 16\n"
            "threads on every instruction set of this machine and compares with the lines of FILE.");
}

bool parse(int count, char** values, Arguments& arguments) {
  for (int i = 1; i < count; i += 2) {
    const std::string_view name = values[i];
    if (i + 1 == count) return false;
    if (name == "--threads") {
      arguments.machine.threads = std::atoi(values[i + 1]);
      if (arguments.machine.threads < 1) return false;
    } else if (name == "--instruction-set") {
      const std::optional<InstructionSet> set = instruction_set_named(values[i + 1]);
      if (!set || !is_supported(*set)) return false;
      arguments.machine.instruction_set = *set;
    } else if (name == "--check") {
      arguments.pinned_file = values[i + 1];
    } else {
      return false;
    }
  }
  return true;
}

/// Ends the program when a scene cannot be drawn: that is a mistake in the scene.
Digests digests_or_exit(const Scene& scene, const PipelineOptions& machine) {
  const Result<Digests> digests = digests_of(scene, machine);
  if (!digests) {
    std::fprintf(stderr, "tuberia_determinism: %s: %s\n", scene.name.c_str(), digests.error().message.c_str());
    std::exit(2);
  }
  return *digests;
}

void print_all(const PipelineOptions& machine) {
  for (const Scene& scene : scenes()) {
    const Digests found = digests_or_exit(scene, machine);
    std::printf("%s %s %s %s\n", scene.name.c_str(), found.colour.c_str(), found.depth.c_str(), found.primitives.c_str());
  }
}

/// The line of a scene; nothing when the file has none.
std::optional<Digests> pinned(const std::string& file, const std::string& scene) {
  std::ifstream lines(file);
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string name;
    Digests digests;
    if (words >> name >> digests.colour >> digests.depth >> digests.primitives && name == scene) return digests;
  }
  return {};
}

/// What differs, for people.
std::string differences(const Digests& found, const Digests& expected) {
  std::string words;
  if (found.colour != expected.colour) words += " colours";
  if (found.depth != expected.depth) words += " depths";
  if (found.primitives != expected.primitives) words += " primitives";
  return words;
}

int check_all(const std::string& file) {
  int tried = 0, failed = 0;
  for (const Scene& scene : scenes()) {
    const std::optional<Digests> expected = pinned(file, scene.name);
    if (!expected) {
      std::fprintf(stderr, "tuberia_determinism: %s has no digests of the scene %s\n", file.c_str(), scene.name.c_str());
      return 2;
    }
    for (const InstructionSet set : supported_instruction_sets())
      for (const int threads : kThreads) {
        const Digests found = digests_or_exit(scene, {.threads = threads, .instruction_set = set});
        ++tried;
        if (found == *expected) continue;
        ++failed;
        std::printf("%s, %s, %d threads: other%s\n", scene.name.c_str(), std::string(name_of(set)).c_str(), threads, differences(found, *expected).c_str());
      }
  }
  std::printf("determinism, tiles of %d pixels: tried %d, failed %d\n", kTileSize, tried, failed);
  return failed == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** values) {
  Arguments arguments;
  if (!parse(count, values, arguments)) {
    print_usage();
    return 2;
  }
  if (!arguments.pinned_file.empty()) return check_all(arguments.pinned_file);
  print_all(arguments.machine);
  return 0;
}
