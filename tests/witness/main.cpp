// tuberia_witness: random triangles, class by class, drawn by the pipeline and worked out in rational
// numbers. Exit status 1 when they differ where no rounding of the contract explains it.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "tests/witness/tally.hpp"

namespace {

using namespace tuberia;
using namespace tuberia::witness;

struct Options {
  std::int64_t triangles = 200'000;
  std::uint64_t seed = 1;
  std::optional<Class> only;
  int threads = 0;
  bool tells_doubts = false;
};

void print_usage() {
  std::puts("usage: tuberia_witness [--triangles N] [--seed S] [--class NAME] [--threads T] [--doubts]\n"
            "Draws about N random triangles of all classes, or of one, and compares coverage, clipping and\n"
            "depth codes with rational arithmetic. --doubts: describes undecided ones, too. T threads; 0\n"
            "takes one a core. The classes:");
  for (int i = 0; i < kClasses; ++i) std::printf("  %s\n", std::string(name_of(static_cast<Class>(i))).c_str());
}

std::optional<std::uint64_t> number_of(const char* text) {
  char* end = nullptr;
  const unsigned long long value = std::strtoull(text, &end, 10);
  if (end == text || *end != '\0') return std::nullopt;
  return value;
}

bool parse(int count, char** arguments, Options& options) {
  for (int i = 1; i < count; ++i) {
    const std::string_view name = arguments[i];
    if (name == "--doubts") {
      options.tells_doubts = true;
      continue;
    }
    if (++i == count) return false;
    if (name == "--class") {
      options.only = class_named(arguments[i]);
      if (!options.only) return false;
      continue;
    }
    const auto value = number_of(arguments[i]);
    if (!value) return false;
    if (name == "--triangles") options.triangles = static_cast<std::int64_t>(*value);
    else if (name == "--seed") options.seed = *value;
    else if (name == "--threads") options.threads = static_cast<int>(*value);
    else return false;
  }
  return options.triangles > 0;
}

void explain(const char* what, Class kind, const std::vector<std::uint64_t>& numbers, std::uint64_t seed, Machines& machines) {
  for (const std::uint64_t number : numbers)
    std::printf("%s: %s, seed %llu, case %llu: %s", what, std::string(name_of(kind)).c_str(), static_cast<unsigned long long>(seed),
                static_cast<unsigned long long>(number), explained(random_case(kind, seed, number), machines).c_str());
}

void print_line(const std::string& name, const Tally& t, double seconds) {
  const auto n = [](std::int64_t x) { return static_cast<long long>(x); };
  std::printf("law: rational witness, %-13s tried %11lld  failed %lld  (undecided %lld; %lld pixels, depth error up to %.2f of what is allowed; %.0f s)\n", name.c_str(),
              n(t.tried), n(t.failed), n(t.undecided), n(t.pixels), t.depth_error, seconds);
  std::fflush(stdout);
}

/// One class, in portions, with a line of progress.
Tally run_class(Class kind, std::int64_t wanted, const Options& options, Workers& workers, std::vector<Machines>& machines) {
  constexpr std::int64_t kPortion = 16384;
  Tally tally;
  for (std::uint64_t first = 0; tally.tried < wanted; first += static_cast<std::uint64_t>(kPortion)) {
    const std::int64_t left = wanted - tally.tried;
    tally += run(kind, options.seed, first, left < kPortion ? left : kPortion, workers, machines);
    std::fprintf(stderr, "\r%-14s %lld of %lld triangles ", std::string(name_of(kind)).c_str(), static_cast<long long>(tally.tried),
                 static_cast<long long>(wanted));
  }
  std::fprintf(stderr, "\r%60s\r", "");
  return tally;
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  if (!parse(count, arguments, options)) {
    print_usage();
    return 2;
  }
  Workers workers(options.threads);
  std::vector<Machines> machines(static_cast<std::size_t>(workers.thread_count()));
  const auto seconds_since = [](auto start) { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  const auto start = std::chrono::steady_clock::now();
  Tally total;
  for (int i = 0; i < kClasses; ++i) {
    const auto kind = static_cast<Class>(i);
    if (options.only && kind != *options.only) continue;
    const auto begin = std::chrono::steady_clock::now();
    const Tally tally = run_class(kind, options.only ? options.triangles : (options.triangles + kClasses - 1) / kClasses, options, workers, machines);
    print_line(std::string(name_of(kind)), tally, seconds_since(begin));
    explain("failed", kind, tally.failures, options.seed, machines[0]);
    if (options.tells_doubts) explain("undecided", kind, tally.doubts, options.seed, machines[0]);
    total += tally;
  }
  print_line("all classes", total, seconds_since(start));
  return total.failed == 0 ? 0 : 1;
}
