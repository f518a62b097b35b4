#pragma once
// Counting the instructions of a frame with valgrind's callgrind.

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/result.hpp"

namespace tuberia::bench {

/// Draws a workload, one of the small ones or of the peers', twice; the second frame, which finds threads and memory ready, goes
/// through a function that callgrind knows by its name. AVX2, one thread. Error for an unknown workload.
Result<Nothing> draw_counted_frame(const std::string& workload);

/// A folder of our own for what callgrind writes, removed with all that is in it.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

/// Runs `THIS PROGRAM --draw WORKLOAD`, which must call draw_counted_frame, under callgrind. Error when there is no valgrind, or when it or
/// the program fails.
Result<std::int64_t> count_instructions(const std::string& workload, const ScratchFolder& scratch);

}  // namespace tuberia::bench
