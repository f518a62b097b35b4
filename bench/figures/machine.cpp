#include "bench/figures/machine.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <thread>

namespace tuberia::bench {
namespace {

std::string processor_name(const std::string& otherwise) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(": ") + 2));
  return otherwise;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[32] = "";
  if (const std::tm* utc = std::gmtime(&now)) std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", utc);
  return text;
}

std::string compiler_name() {
#if defined(__clang__)
  return std::string("clang++ ") + __clang_version__;
#else
  return std::string("g++ ") + __VERSION__;
#endif
}

// A chain in which each step needs the one before: a multiplication and an addition, which take 3
// and 1 cycles on every x86 core of the last fifteen years (and 4 or 5 together on others). The
// fastest of several tries is the one that was not interrupted.
double measure_clock_hertz() {
  constexpr int kSteps = 500'000, kTries = 100;  // half a millisecond each
  constexpr double kCyclesPerStep = 4;
  double best = 0;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    std::uint64_t state = static_cast<std::uint64_t>(begin.time_since_epoch().count());
    for (int i = 0; i < kSteps; ++i) state = state * 6364136223846793005u + 1442695040888963407u;
    [[maybe_unused]] volatile std::uint64_t used = state;
    best = std::max(best, kSteps * kCyclesPerStep / std::chrono::duration<double>(Clock::now() - begin).count());
  }
  return best;
}

}  // namespace

Machine this_machine(const std::string& commit) {
  Machine machine;
  machine.processor = processor_name(machine.processor);
  machine.compiler = compiler_name();
  machine.date = today();
  machine.commit = commit;
  machine.cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  machine.clock_hertz = measure_clock_hertz();
  return machine;
}

std::string sentence_of(const Machine& machine) {
  char numbers[64];
  std::snprintf(numbers, sizeof numbers, ", %d %s at %.2f GHz (measured), ", machine.cores,
                machine.cores == 1 ? "core" : "cores", machine.clock_hertz * 1e-9);
  std::string sentence = machine.processor + numbers + machine.compiler + ", " + machine.date;
  if (!machine.commit.empty()) sentence += ", commit " + machine.commit;
  return sentence;
}

}  // namespace tuberia::bench
