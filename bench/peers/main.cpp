// Compares Tuberia with llvmpipe on the same frames: script/bench peers.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bench/peers/comparison.hpp"
#include "bench/peers/peer.hpp"
#include "image/compare.hpp"
#include "image/write_image.hpp"

namespace tuberia::bench {

namespace {

struct Options {
  std::vector<std::string> prefixes;
  int threads = 2;
  double seconds = 0.5;
  std::string json_file, dump_folder, instruction_set, precision = "fast";
};

int fail(const std::string& message) {
  std::fprintf(stderr, "%s\n", message.c_str());
  return 1;
}

// Fills `options`; returns whether to go on, with the exit status in `status` if not.
bool parse(int argc, char** argv, Options& options, int& status) {
  CLI::App app{"Times Tuberia and llvmpipe on the same frames, in turns.", "tuberia_peers"};
  app.add_option("workload", options.prefixes, "Run only workloads whose names begin with one of these");
  app.add_option("--threads", options.threads, "Threads of each peer")->check(CLI::Range(1, 16))->capture_default_str();
  app.add_option("--time", options.seconds, "Seconds the slower peer is timed on each workload")
      ->check(CLI::Range(0.0, 3600.0))->capture_default_str();
  app.add_option("--json", options.json_file, "Write the figures to this file");
  app.add_option("--dump", options.dump_folder, "Write both pictures and their difference to this folder");
  app.add_option("--isa", options.instruction_set, "Tuberia's instruction set (default: the widest)");
  app.add_option("--precision", options.precision, "Tuberia's precision")
      ->check(CLI::IsMember({"exact", "fast"}))->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    status = app.exit(error);
    return false;
  }
  return true;
}

Result<std::unique_ptr<Peer>> make_our_peer(const Options& options) {
  const auto instruction_set = options.instruction_set.empty() ? best_instruction_set()
                                                               : instruction_set_named(options.instruction_set);
  if (!instruction_set || !is_supported(*instruction_set))
    return Error{"this machine has no instruction set called " + options.instruction_set};
  return make_tuberia_peer(options.threads, *instruction_set,
                           options.precision == "exact" ? Precision::exact : Precision::fast);
}

std::vector<std::string> chosen_workloads(const std::vector<std::string>& prefixes) {
  std::vector<std::string> names = workload_names();
  std::erase_if(names, [&](const std::string& name) {
    return !prefixes.empty() && std::none_of(prefixes.begin(), prefixes.end(), [&](const std::string& prefix) {
      return name.starts_with(prefix);
    });
  });
  return names;
}

// Writes <workload>_<peer>.png of each and <workload>_difference.png, and says how far they differ.
Result<Nothing> dump(const std::filesystem::path& folder, const std::string& workload, Peer& ours, Peer& theirs) {
  const Image<Rgba8> our_picture = ours.picture(), their_picture = theirs.picture();
  const auto comparison = compare(our_picture, their_picture);
  if (!comparison) return comparison.error();
  const struct {
    std::string name;
    Image<Rgba8> image;
  } pictures[] = {{ours.name(), our_picture},
                  {theirs.name(), their_picture},
                  {"difference", difference_image(our_picture, their_picture)}};
  for (const auto& picture : pictures)
    if (auto written = write_image(folder / (workload + "_" + picture.name + ".png"), picture.image); !written)
      return written;
  std::printf("%24s %lld of %zu pixels differ, by at most %d codes\n", "",
              static_cast<long long>(comparison->differing_pixels), our_picture.pixels().size(),
              comparison->largest_difference);
  return Nothing{};
}

void print_heading(const Peer& ours, const Peer& theirs) {
  std::printf("%24s %11s   %11s   %11s   %11s %8s %6s\n", "", ours.name().c_str(), "", theirs.name().c_str(), "",
              "times", "");
  std::printf("%-24s %11s   %11s   %11s   %11s %8s %6s\n", "workload", "median ms", "min ms", "median ms", "min ms",
              "faster", "pairs");
}

void print(const Timing& timing) {
  std::printf("%-24s %11.3f   %11.3f   %11.3f   %11.3f %8.2f %6d\n", timing.workload.c_str(), timing.first_median_ms,
              timing.first_smallest_ms, timing.second_median_ms, timing.second_smallest_ms, timing.ratio,
              timing.pairs);
  std::fflush(stdout);
}

Result<Nothing> write_json(const std::string& path, const std::vector<Timing>& timings) {
  nlohmann::ordered_json figures = nlohmann::ordered_json::array();
  for (const Timing& timing : timings)
    figures.push_back(nlohmann::ordered_json{{"workload", timing.workload},
                                             {"ours_ms", timing.first_median_ms},
                                             {"peer_ms", timing.second_median_ms},
                                             {"ratio", timing.ratio}});
  std::ofstream file(path);
  file << figures.dump(2) << '\n';
  file.close();
  if (!file) return Error{"cannot write " + path};
  return Nothing{};
}

Result<Timing> run(const std::string& name, const Options& options, Peer& ours, Peer& theirs) {
  const auto workload = make_workload(name);
  if (!workload) return workload.error();
  for (Peer* peer : {&ours, &theirs})
    if (const auto prepared = peer->prepare(*workload); !prepared) return prepared.error();
  const Timing timing = time_in_turns(*workload, ours, theirs, options.seconds);
  print(timing);
  if (!options.dump_folder.empty())
    if (const auto dumped = dump(options.dump_folder, name, ours, theirs); !dumped) return dumped.error();
  return timing;
}

int compare_peers(const Options& options) {
  const auto names = chosen_workloads(options.prefixes);
  if (names.empty()) return fail("No workload has such a name.");
  if (!options.dump_folder.empty()) {
    std::error_code error;
    std::filesystem::create_directories(options.dump_folder, error);
    if (error) return fail("cannot make " + options.dump_folder + ": " + error.message());
  }
  const auto theirs = make_osmesa_peer(options.threads);
  if (!theirs) return fail(theirs.error().message);
  const auto ours = make_our_peer(options);
  if (!ours) return fail(ours.error().message);

  print_heading(**ours, **theirs);
  std::vector<Timing> timings;
  for (const std::string& name : names) {
    const auto timing = run(name, options, **ours, **theirs);
    if (!timing) return fail(name + ": " + timing.error().message);
    timings.push_back(*timing);
  }
  if (!options.json_file.empty())
    if (const auto written = write_json(options.json_file, timings); !written) return fail(written.error().message);
  return 0;
}

}  // namespace

}  // namespace tuberia::bench

int main(int argc, char** argv) {
  tuberia::bench::Options options;
  int status = 0;
  if (!tuberia::bench::parse(argc, argv, options, status)) return status;
  return tuberia::bench::compare_peers(options);
}
