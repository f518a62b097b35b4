// Compares Tuberia with llvmpipe on the same frames: script/bench peers.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/figures/command_line.hpp"
#include "bench/peers/comparison.hpp"
#include "bench/peers/peer.hpp"
#include "bench/peers/pinning.hpp"
#include "bench/peers/report.hpp"
#include "image/compare.hpp"
#include "image/write_image.hpp"

namespace tuberia::bench {

namespace {

struct Options {
  std::vector<std::string> prefixes;
  int threads = 2, rounds = 7;
  double seconds = 0.5;
  std::string json_file, dump_folder, instruction_set, precision = "exact";
  Requirement requirement;
};

int fail(const std::string& message) {
  std::fprintf(stderr, "%s\n", message.c_str());
  return 1;
}

void add_options(CommandLine& line, Options& options) {
  line.words("workload", options.prefixes, "Run only workloads whose names begin with one of these");
  line.whole("--threads", options.threads, 1, 16, "Threads of each peer, and cores that both are kept to");
  line.whole("--rounds", options.rounds, 5, 10000, "Rounds of each workload, one frame of each peer, at least");
  line.number("--time", options.seconds, 0, 3600, "Seconds the slower peer is timed on each workload, at least");
  line.json(options.json_file);
  line.text("--dump", options.dump_folder, "Write both pictures and their difference to this folder");
  line.text("--isa", options.instruction_set, "Tuberia's instruction set: sse4, avx2 or avx3 (default: the widest)");
  line.one_of("--precision", options.precision, {"exact", "fast"}, "Tuberia's precision");
  line.number("--require-mean", options.requirement.mean, 0, 1e6, "Exit status 1 if the geometric mean of the ratios is below this");
  line.number("--require-least", options.requirement.least, 0, 1e6, "Exit status 1 if any ratio is below this");
}

Result<std::unique_ptr<Peer>> make_our_peer(const Options& options) {
  const auto instruction_set = instruction_set_from(options.instruction_set);
  if (!instruction_set) return instruction_set.error();
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

Result<Timing> run(const std::string& name, const Options& options, Peer& ours, Peer& theirs) {
  const auto workload = make_workload(name);
  if (!workload) return workload.error();
  for (Peer* peer : {&ours, &theirs})
    if (const auto prepared = peer->prepare(*workload); !prepared) return prepared.error();
  const Timing timing = time_in_turns(*workload, ours, theirs, options.seconds, options.rounds);
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
  const std::string pinned = keep_to_cores(options.threads);
  const auto theirs = make_osmesa_peer(options.threads);
  if (!theirs) return fail(theirs.error().message);
  const auto ours = make_our_peer(options);
  if (!ours) return fail(ours.error().message);

  std::printf("%d %s each, %s; tuberia: %s, %s precision.\n\n", options.threads, options.threads == 1 ? "thread" : "threads",
              pinned.c_str(), std::string(name_of(instruction_set_from(options.instruction_set).value())).c_str(), options.precision.c_str());
  print_heading(**ours, **theirs);
  std::vector<Timing> timings;
  for (const std::string& name : names) {
    const auto timing = run(name, options, **ours, **theirs);
    if (!timing) return fail(name + ": " + timing.error().message);
    timings.push_back(*timing);
  }
  if (!options.json_file.empty())
    if (const auto written = write_json(options.json_file, timings); !written) return fail(written.error().message);
  return print_summary(timings, options.requirement) ? 0 : 1;
}

}  // namespace

}  // namespace tuberia::bench

int main(int argc, char** argv) {
  tuberia::bench::CommandLine line("Times Tuberia and llvmpipe on the same frames, in turns.", "tuberia_peers");
  tuberia::bench::Options options;
  tuberia::bench::add_options(line, options);
  if (const auto status = line.parse(argc, argv)) return *status;
  return tuberia::bench::compare_peers(options);
}
