#include "bench/guard/counting.hpp"

#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "bench/guard/small_workloads.hpp"
#include "bench/peers/tuberia_peer.hpp"

namespace tuberia::bench {
namespace {

// Callgrind counts what happens below the function of this name.
constexpr const char* kCountedFunction = "tuberia::bench::counted_frame*";

std::string quoted(const std::filesystem::path& path) {
  std::string text = "'";
  for (const char c : path.string()) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

// The file says "totals: N" after the costs of every line.
Result<std::int64_t> total_of(const std::filesystem::path& counts) {
  std::ifstream file(counts);
  const std::string key = "totals: ";
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(key)) return std::int64_t{std::strtoll(line.c_str() + key.size(), nullptr, 10)};
  return Error{"callgrind wrote no totals"};
}

}  // namespace

[[gnu::noinline]] void counted_frame(Peer& peer) {
  peer.frame();
  asm volatile("");  // or this would be a jump to the frame, and its return ours
}

Result<Nothing> draw_counted_frame(const std::string& name) {
  auto workload = make_small_workload(name);
  if (!workload) workload = make_workload(name);
  if (!workload) return workload.error();
  TuberiaPeer peer(1, InstructionSet::avx2, Precision::exact);
  if (auto prepared = peer.prepare(*workload); !prepared) return prepared;
  peer.frame();
  counted_frame(peer);
  return Nothing{};
}

ScratchFolder::ScratchFolder()
    : path_(std::filesystem::temp_directory_path() / ("tuberia_counts_" + std::to_string(getpid()))) {
  std::filesystem::create_directories(path_);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Result<std::int64_t> count_instructions(const std::string& workload, const ScratchFolder& scratch) {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path counts = scratch.path() / (workload + ".callgrind"),
                              log = scratch.path() / (workload + ".log");
  const std::string command = "valgrind --tool=callgrind --callgrind-out-file=" + quoted(counts) +
                              " --toggle-collect='" + kCountedFunction + "' " + quoted(program) + " --draw " +
                              workload + " > " + quoted(log) + " 2>&1";
  if (std::system(command.c_str()) != 0) {
    std::ifstream file(log);
    std::string said, line;
    while (std::getline(file, line)) said += "\n    " + line;
    return Error{workload + ": valgrind, or the program under it, failed:" + said};
  }
  auto total = total_of(counts);
  if (!total) return Error{workload + ": " + total.error().message};
  if (*total == 0) return Error{workload + ": callgrind counted nothing; are the program's symbols stripped?"};
  return total;
}

}  // namespace tuberia::bench
