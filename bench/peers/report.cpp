#include "bench/peers/report.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <vector>

#include "bench/figures/statistics.hpp"

namespace tuberia::bench {

void print_heading(const Peer& ours, const Peer& theirs) {
  std::printf("%-24s %19s   %19s   %8s   %13s %6s\n", "", ours.name().c_str(), theirs.name().c_str(), "times",
              "middle half", "");
  std::printf("%-24s %9s %9s   %9s %9s   %8s   %13s %6s\n", "workload", "median ms", "min ms", "median ms", "min ms",
              "faster", "of the rounds", "rounds");
}

void print(const Timing& timing) {
  std::printf("%-24s %9.3f %9.3f   %9.3f %9.3f   %8.2f   %5.2f - %5.2f %6d\n", timing.workload.c_str(),
              timing.first_median_ms, timing.first_smallest_ms, timing.second_median_ms, timing.second_smallest_ms,
              timing.ratio, timing.lower_quartile, timing.upper_quartile, timing.rounds);
  std::fflush(stdout);
}

bool print_summary(std::span<const Timing> timings, const Requirement& requirement) {
  std::vector<double> ratios;
  for (const Timing& timing : timings) ratios.push_back(timing.ratio);
  const auto least = std::min_element(timings.begin(), timings.end(),
                                      [](const Timing& a, const Timing& b) { return a.ratio < b.ratio; });
  const double mean = geometric_mean(ratios);
  std::printf("\nGeometric mean %.2f times faster; least %.2f (%s).\n", mean, least->ratio, least->workload.c_str());

  bool met = true;
  if (requirement.mean > 0 && mean < requirement.mean) {
    std::printf("The mean was to be at least %.2f.\n", requirement.mean);
    met = false;
  }
  for (const Timing& timing : timings) {
    if (timing.ratio >= requirement.least) continue;
    std::printf("%s was to be at least %.2f times faster, but is %.2f.\n", timing.workload.c_str(), requirement.least,
                timing.ratio);
    met = false;
  }
  return met;
}

Result<Nothing> write_json(const std::string& path, std::span<const Timing> timings) {
  nlohmann::ordered_json figures = nlohmann::ordered_json::array();
  for (const Timing& timing : timings)
    figures.push_back(nlohmann::ordered_json{{"workload", timing.workload},
                                             {"ours_ms", timing.first_median_ms},
                                             {"peer_ms", timing.second_median_ms},
                                             {"ratio", timing.ratio},
                                             {"ratio_quartiles", {timing.lower_quartile, timing.upper_quartile}},
                                             {"rounds", timing.rounds}});
  std::ofstream file(path);
  file << figures.dump(2) << '\n';
  file.close();
  if (!file) return Error{"cannot write " + path};
  return Nothing{};
}

}  // namespace tuberia::bench
