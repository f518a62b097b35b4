#include "bench/account/report.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>

namespace tuberia::bench {
namespace {

struct NamedBound {
  const char* name;
  double seconds;
};

NamedBound largest_bound(const Bounds& bounds) {
  NamedBound largest{"memory", bounds.memory};
  if (bounds.first_cache > largest.seconds) largest = {"first cache", bounds.first_cache};
  if (bounds.texels > largest.seconds) largest = {"texels", bounds.texels};
  if (bounds.instructions > largest.seconds) largest = {"instructions", bounds.instructions};
  return largest;
}

double share(double part, double whole) { return whole > 0 ? part / whole : 0; }

}  // namespace

bool scales_too_little(const Account& account) noexcept {
  return account.frame_seconds > kSpeedUpFromSeconds && account.speed_up_of_two < kSpeedUpOfTwo;
}

void print_account_heading() {
  std::printf("%-24s %9s  %15s  %15s  %-24s %-22s %9s %11s\n", "", "", "geometry cycles", "tile cycles", "", "",
              "2 threads", "64 threads");
  std::printf("%-24s %9s  %15s  %15s  %-24s %-22s %9s %11s\n", "workload", "ms", "a triangle", "a fragment",
              "largest item", "largest bound", "(measured)", "(simulated)");
}

void print(const Account& account, double clock_hertz) {
  const auto triangles = static_cast<double>(account.triangles),
             fragments = static_cast<double>(account.counts.fragments);
  const Item item = account.largest_item();
  const NamedBound bound = largest_bound(account.bounds);
  char item_text[48], bound_text[48];
  std::snprintf(item_text, sizeof item_text, "%s %.0f %%", std::string(name_of(item)).c_str(),
                100 * account.of(item) / account.frame_seconds);
  std::snprintf(bound_text, sizeof bound_text, "%s %.0f %%", bound.name, 100 * bound.seconds / account.frame_seconds);
  std::printf("%-24s %9.3f  %15.1f  %15.2f  %-24s %-22s %8.2fx %10.2fx\n", account.workload.c_str(),
              1e3 * account.frame_seconds, share(account.geometry_seconds() * clock_hertz, triangles),
              share(account.tile_seconds() * clock_hertz, fragments), item_text, bound_text, account.speed_up_of_two,
              account.work.total() / account.work.duration(kMostSimulatedThreads));
  std::fflush(stdout);
}

Result<Nothing> write_json(const std::string& path, std::span<const Account> accounts, const Machine& machine) {
  using Json = nlohmann::ordered_json;
  Json workloads = Json::array();
  for (const Account& account : accounts) {
    Json items, balance;
    for (int i = 0; i < kItems; ++i)
      items[std::string(name_of(static_cast<Item>(i)))] = 1e3 * account.seconds[static_cast<std::size_t>(i)];
    for (const int threads : kSimulatedThreads) balance[std::to_string(threads)] = account.work.balance(threads);
    workloads.push_back({{"workload", account.workload},
                         {"frame_ms", 1e3 * account.frame_seconds},
                         {"items_ms", items},
                         {"triangles", account.triangles},
                         {"triangles_drawn", account.counts.triangles_drawn},
                         {"fragments", account.counts.fragments},
                         {"visible_fragments", account.visible},
                         {"bounds_ms",
                          {{"memory", 1e3 * account.bounds.memory},
                           {"first_cache", 1e3 * account.bounds.first_cache},
                           {"texels", 1e3 * account.bounds.texels},
                           {"instructions", 1e3 * account.bounds.instructions}}},
                         {"instructions", account.instructions},
                         {"longest_chain_ms", 1e3 * account.work.longest_chain(kMostSimulatedThreads)},
                         {"alone_ms", 1e3 * account.work.alone},
                         {"balance", balance},
                         {"speed_up_of_two_threads", account.speed_up_of_two}});
  }
  const Json all{{"machine", sentence_of(machine)}, {"clock_hertz", machine.clock_hertz}, {"workloads", workloads}};
  std::ofstream file(path);
  file << all.dump(2) << '\n';
  file.close();
  if (!file) return Error{"cannot write " + path};
  return Nothing{};
}

}  // namespace tuberia::bench
